// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSpectralSegmentationConcepts
\cgalConcept

Experimental: a model of this concept computes the salience of a cut from its factors.

`CGAL::segment_spectral_recursive()` copies the model. With `CGAL::Parallel_tag` several threads may
call the copy at the same time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spectral_segmentation::Weighted_part_salience}
\cgalHasModels{CGAL::Spectral_segmentation::Calibrated_part_salience}
\cgalHasModelsEnd
*/
class PartSalience
{
public:
  /// returns the salience of the cut, which is larger for a more salient cut and must not be NaN.
  /// The same factors must give the same salience. Differences below a millionth are ignored.
  double operator()(const CGAL::Spectral_segmentation::Salience_factors& factors) const;
};

// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSpectralSegmentationConcepts
computes the salience of a cut from its factors.

\cgalConcept

`CGAL::segment_spectral_recursive()` copies it. With `CGAL::Parallel_tag` several threads may call
the copy at the same time.

\cgalHasModels{`CGAL::Spectral_segmentation::Weighted_part_salience`,
`CGAL::Spectral_segmentation::Calibrated_part_salience`}
*/
class PartSalience
{
public:
  /// returns the salience: a larger number for a more salient cut, and not a NaN. The same factors
  /// must give the same number. Differences below a millionth do not count.
  double operator()(const CGAL::Spectral_segmentation::Salience_factors& factors) const;
};

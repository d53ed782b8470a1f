// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSpectralSegmentationConcepts
judges a cut by its factors.

\cgalConcept

`CGAL::segment_spectral_recursive()` copies it, and calls the copy from
several threads at a time with `CGAL::Parallel_tag`.

\cgalHasModels{`CGAL::Spectral_segmentation::Weighted_part_salience`,
`CGAL::Spectral_segmentation::Calibrated_part_salience`}
*/
class PartSalience
{
public:
  /// returns a number that is the larger the more salient the cut is; never a NaN. The same factors
  /// must give the same number. Differences below a millionth do not count.
  double operator()(const CGAL::Spectral_segmentation::Salience_factors& factors) const;
};

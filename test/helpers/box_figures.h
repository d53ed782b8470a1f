// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_BOX_FIGURES_H
#define SPECTRAL_SEGMENTATION_TEST_BOX_FIGURES_H

#include "test_meshes.h"

#include <array>
#include <cstddef>
#include <map>
#include <set>

// Figures that are made of unit cubes.
namespace test_meshes {

typedef std::array<int, 3> Cell;
typedef std::set<Cell> Cells;

void add_box(Cells& cells, const Cell& low, const Cell& high);

// The boundary of a set of unit cubes, each square cut in two; on demand open in the plane z = 0.
Soup boundary_of(const Cells& cells, bool is_open = false);

// A closed figure with a body, a head, two arms and two legs, of 328 faces. It has no symmetry, so
// that no two cuts are equally salient.
const Soup& doll();

} // namespace test_meshes

#endif // SPECTRAL_SEGMENTATION_TEST_BOX_FIGURES_H

// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE Spectral_segmentation
#include <boost/test/unit_test.hpp>

// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Names and arguments that parameters.h refuses.

#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>

namespace params = CGAL::Spectral_segmentation::parameters;

typedef CGAL::Spectral_segmentation::Salience_factors Salience_factors;

auto pack_01 = params::vertex_point_map(5);              // error: vertex_point_map takes a property map
auto pack_02 = params::face_index_map(5);                // error: face_index_map takes a property map
auto pack_03 = params::geom_traits(3);                   // error: geom_traits takes a class with the functor Compute_x_3
auto pack_04 = params::random_seed(1.5);                 // error: random_seed takes an integer
auto pack_05 = params::visitor(3); // error: visitor takes a class derived from Segmentation_visitor that redefines one of its functions, or std::ref to one; is a name misspelt
struct Misspelt_visitor : CGAL::Spectral_segmentation::Segmentation_visitor
{
  bool go_futher() { return false; }
};

auto pack_05b = params::visitor(Misspelt_visitor()); // error: visitor takes a class derived from Segmentation_visitor that redefines one of its functions, or std::ref to one; is a name misspelt

auto pack_06 = params::maximum_number_of_segments(true); // error: maximum_number_of_segments takes an integer
auto pack_07 = params::maximum_number_of_segments(2.5);  // error: maximum_number_of_segments takes an integer
auto pack_08 = params::minimum_segment_size("small");    // error: minimum_segment_size takes a number
auto pack_09 = params::minimum_segment_size(true);       // error: minimum_segment_size takes a number
auto pack_10 = params::salience_threshold("high");       // error: salience_threshold takes a number
auto pack_11 = params::part_salience(0.5);               // error: part_salience takes a class that is called with Salience_factors
auto pack_12 = params::number_of_reference_faces(0.5);   // error: number_of_reference_faces takes an integer
auto pack_13 = params::number_of_coarse_faces(0.5);    // error: number_of_coarse_faces takes an integer
auto pack_13b = params::number_of_searches("5");          // error: number_of_searches takes an integer
auto pack_14 = params::number_of_smoothing_iterations("3"); // error: number_of_smoothing_iterations takes an integer
auto pack_15 = params::keep_components_separate(1);     // error: keep_components_separate takes a bool

// A test of a threshold is no salience.
auto pack_16 = params::part_salience([](const Salience_factors& f) { return f.size > 0.1; }); // error: part_salience takes a class that is called with Salience_factors

auto pack_17 = params::salience_weights("0.1", "0.6", "0.3"); // error: salience_weights takes three numbers: alpha, beta, gamma
auto pack_18 = params::salience_weights(0.1, 0.9);            // error: no matching (member )?function for call to .*salience_weights
auto pack_19 = params::distance_weights(0.03, "1", 0.1);      // error: distance_weights takes three numbers: delta, eta at concave edges
auto pack_20 = params::distance_weights(0.03, 1);             // error: no matching (member )?function for call to .*distance_weights
auto pack_21 = params::random_seed(1).distance_weights(0.03); // error: no matching (member )?function for call to .*distance_weights
auto pack_22 = params::zhang_liu_2005(true);                  // error: too many arguments to function|no matching function for call to .*zhang_liu_2005

CGAL::Spectral_segmentation::Segmentation_hierarchy& a_hierarchy();
const CGAL::Spectral_segmentation::Segmentation_hierarchy& a_const_hierarchy();
auto pack_23 = params::hierarchy(a_hierarchy()).zhang_liu_2005(); // compiles
auto pack_24 = params::hierarchy(a_const_hierarchy());            // error: hierarchy takes a CGAL::Spectral_segmentation::Segmentation_hierarchy, not const

CGAL::Spectral_segmentation::Options some_options();
auto pack_36 = params::options(some_options()).salience_threshold(0.3); // compiles
auto pack_37 = params::options(3);                            // error: options takes a CGAL::Spectral_segmentation::Options

auto pack_25 = params::salience_treshold(0.3);                // error: did you mean 'salience_threshold'
auto pack_26 = params::random_seed(1).salience_treshold(0.3); // error: did you mean 'salience_threshold'
auto pack_27 = params::method(1);                             // error: 'method'
auto pack_28 = params::number_of_regions(7);                  // error: 'number_of_regions'

auto pack_29 = params::edge_is_constrained_map(true); // error: edge_is_constrained_map takes a property map
auto pack_30 = params::edge_is_uncuttable_map(true);  // error: edge_is_uncuttable_map takes a property map
unsigned seeds_without_sign[3];
const void* texts[3];
auto pack_31 = params::face_seed_map(seeds_without_sign + 0); // error: face_seed_map takes a property map with values of a signed integer type
auto pack_45 = params::face_feature_map(texts + 0); // error: face_feature_map takes a property map whose values are numbers or ranges of numbers
auto pack_46 = params::feature_weight("much");      // error: feature_weight takes a number

auto pack_33 = params::number_of_segment(5);                       // error: did you mean 'number_of_segments'
auto pack_34 = params::random_seed(1).number_of_segment(5);        // error: did you mean 'number_of_segments'

// The members of a pack of CGAL are CGAL's own, so that the message comes from the compiler.
auto pack_35 = CGAL::parameters::random_seed(1).number_of_segments(5); // error: no member named 'number_of_segments'

auto pack_38 = CGAL::parameters::number_of_segments(2.5);            // error: number_of_segments takes an integer
auto pack_39 = CGAL::parameters::number_of_segments(5).verbose(true); // error: no member named 'verbose'
auto pack_40 = CGAL::parameters::hierarchy(5);                       // error: no matching function for call to .*hierarchy|no type named 'type' in 'struct std::enable_if
auto pack_41 = CGAL::parameters::combine(5, params::random_seed(1)); // error: no matching function for call to .*combine
auto pack_42 = CGAL::parameters::combine(params::random_seed(1), 5); // error: no matching (member )?function for call to .*combine

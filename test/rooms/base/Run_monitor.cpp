// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(run_monitor)

namespace tt = boost::test_tools;
using namespace CGAL::Spectral_segmentation::internal;

namespace {

const double smallest_step = 0.002; // the step of the reported progress

struct Progress_record : Run_control
{
  std::vector<double> told;

  void progress(double fraction) override { told.push_back(fraction); }
};

// Says no to the n-th question.
struct Stopper : Run_control
{
  int asked = 0;
  int stops_at;

  explicit Stopper(int n) : stops_at(n) {}
  bool go_further() override { return ++asked < stops_at; }
};

} // namespace

BOOST_AUTO_TEST_CASE(progress_never_falls_and_stays_in_its_phase)
{
  for (unsigned seed = 1; seed <= 50; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> uniform(0, 1);
      Progress_record record;
      Run_monitor monitor(record);
      double start = 0;
      for (double fraction : {0.1, 0.6, 0.0, 0.25}) {
        monitor.start_phase(fraction);
        const std::size_t first = record.told.size();
        for (int i = 0; i < 200; ++i)
          switch (random() % 4) {
          case 0: monitor.advance(uniform(random) / 20); break;
          case 1: monitor.approach(uniform(random) / 20); break;
          case 2: monitor.advance_to(uniform(random)); break;
          case 3: monitor.advance_to(2 * uniform(random) - 1); break;
          }
        for (std::size_t i = first; i < record.told.size(); ++i) {
          BOOST_TEST(record.told[i] >= start);
          BOOST_TEST(record.told[i] <= start + fraction + 1e-12);
        }
        start += fraction;
      }
      monitor.finish();
      for (std::size_t i = 1; i < record.told.size(); ++i)
        BOOST_TEST(record.told[i] >= record.told[i - 1] + (i + 1 < record.told.size()
                                                             ? smallest_step * (1 - 1e-9) : 0));
      BOOST_TEST(record.told.size() > 5u);
      BOOST_TEST(record.told.back() == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(phases_add_up_to_the_run)
{
  Progress_record record;
  Run_monitor monitor(record);
  monitor.start_phase(0.3);
  monitor.start_phase(0.5); // the first was done, whatever it told of itself
  BOOST_TEST(record.told == std::vector<double>({0.3}), tt::per_element());
  monitor.advance(0.5);
  BOOST_TEST(record.told.back() == 0.55, tt::tolerance(1e-12));
  monitor.start_phase(1); // no more than the rest
  BOOST_TEST(record.told.back() == 0.8, tt::tolerance(1e-12));
  monitor.advance(0.5);
  BOOST_TEST(record.told.back() == 0.9, tt::tolerance(1e-12));
  monitor.advance_to(1);
  BOOST_TEST(record.told.back() == 1);
}

BOOST_AUTO_TEST_CASE(a_phase_advances_by_its_own_fractions)
{
  Progress_record record;
  Run_monitor monitor(record);
  monitor.start_phase(0.5);
  for (int i = 0; i < 4; ++i)
    monitor.advance(0.25);
  BOOST_TEST(record.told == std::vector<double>({0.125, 0.25, 0.375, 0.5}), tt::per_element());
  monitor.advance(0.25); // it does not leave its phase
  BOOST_TEST(record.told.size() == 4u);
  monitor.start_phase(0.5);
  for (int i = 0; i < 3; ++i)
    monitor.approach(0.5);
  BOOST_TEST(record.told == std::vector<double>({0.125, 0.25, 0.375, 0.5, 0.75, 0.875, 0.9375}),
             tt::per_element());
  monitor.advance_to(0.5); // more than that is done
  BOOST_TEST(record.told.size() == 7u);
}

BOOST_AUTO_TEST_CASE(small_steps_are_told_together)
{
  Progress_record record;
  Run_monitor monitor(record);
  monitor.start_phase(1);
  for (int i = 0; i < 100000; ++i)
    monitor.advance(1e-5);
  BOOST_TEST(record.told.size() <= 500u);
  BOOST_TEST(record.told.size() >= 490u);
  BOOST_TEST(record.told.back() > 1 - 2 * smallest_step);
}

BOOST_AUTO_TEST_CASE(the_caller_is_not_asked_again_after_a_no)
{
  for (int n : {1, 2, 5}) {
    Stopper stopper(n);
    Run_monitor monitor(stopper);
    for (int i = 1; i <= 10; ++i) {
      BOOST_TEST(monitor.is_stopped() == (i > n));
      BOOST_TEST(monitor.go_further() == (i < n));
      BOOST_TEST(stopper.asked == std::min(i, n));
    }
    BOOST_CHECK_THROW(monitor.check(), Run_stopped);
    BOOST_TEST(stopper.asked == n);
  }
  Stopper never(1000);
  Run_monitor monitor(never);
  for (int i = 0; i < 10; ++i)
    BOOST_CHECK_NO_THROW(monitor.check());
  BOOST_TEST(never.asked == 10);
}

BOOST_AUTO_TEST_CASE(counted_steps_ask_the_caller_now_and_then)
{
  Stopper stopper(20);
  Run_monitor monitor(stopper);
  for (int i = 0; i < 100000; ++i)
    monitor.count_steps(10);
  BOOST_TEST(stopper.asked >= 3); // a million steps take some milliseconds
  BOOST_TEST(stopper.asked < 20);
  for (int i = 0; i < 100; ++i)
    monitor.count_steps(1000000); // of one call
  BOOST_TEST(stopper.asked == 20); // no question after the answer
  BOOST_TEST(monitor.is_stopped());
}

BOOST_AUTO_TEST_SUITE_END()

// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_PYTHON_RUN_H
#define SPECTRAL_SEGMENTATION_PYTHON_PYTHON_RUN_H

#include "Worker.h"
#include "python_lock.h"

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>

#include <pybind11/pybind11.h>

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace python {

namespace py = pybind11;

// A run in another thread, without Python's lock. The caller's thread waits: there, and only there,
// signals are handled and progress is reported, because Python handles signals in its main thread.
class Python_run : public CGAL::Spectral_segmentation::Segmentation_visitor
{
public:
  struct Abandoned {}; // unwinds the run, whose result nobody will see

private:
  // The data that Python's lock guards. A process that was forked has none of the threads of its
  // parent.
  struct Process
  {
    pid_t id = getpid();
    std::vector<Worker*> idle; // TBB keeps memory for each thread that ever called it
    std::set<Python_run*> runs;
    std::thread::id ending_thread; // the one that ends the process
  };

  static Process& process()
  {
    static Process result;
    if (result.id != getpid())
      result = Process();
    return result;
  }

  const py::object progress_; // a callable or None
  std::mutex mutex_;
  std::condition_variable changed_;
  double fraction_ = 0;                    // of the run that is done
  bool is_done_ = false;
  std::exception_ptr error_;               // thrown by the run
  std::exception_ptr error_of_python_;     // raised by a callable or a signal
  std::atomic<bool> is_stopped_{false}, is_abandoned_{false};
  double reported_fraction_ = 0;

  // Ends the thread without a message.
  [[noreturn]] static void throw_system_exit()
  {
    PyErr_SetNone(PyExc_SystemExit);
    throw py::error_already_set();
  }

  // Handles signals and reports the progress, holding Python's lock.
  void report(double fraction)
  {
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    if (progress_.is_none() || fraction <= reported_fraction_ || is_stopped_)
      return;
    reported_fraction_ = fraction;
    const py::object answer = call(progress_, py::float_(fraction));
    if (!answer.is_none() && !py::bool_(answer))
      is_stopped_ = true;
  }

  // Returns once the run is done. Waits without Python's lock.
  void wait()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!is_done_) {
      const bool is_reported = !progress_.is_none() && !is_stopped_ && !is_abandoned_;
      changed_.wait_for(lock, std::chrono::milliseconds(50),
                        [&] {
                          return is_done_ || (is_reported && fraction_ > reported_fraction_);
                        });
      if (is_done_ || is_abandoned_)
        continue;
      const double fraction = fraction_;
      lock.unlock();
      {
        const Python_lock python_lock;
        try {
          report(fraction);
        }
        catch (...) {
          abandon(std::current_exception());
        }
      }
      lock.lock();
    }
  }

public:
  explicit Python_run(const py::object& progress) : progress_(progress) {}

  void progress(double fraction)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    fraction_ = fraction;
    changed_.notify_one();
  }

  bool go_further()
  {
    if (is_abandoned_)
      throw Abandoned();
    return !is_stopped_;
  }

  // Ends the run; the caller gets the first error.
  void abandon(const std::exception_ptr& error)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!error_of_python_)
      error_of_python_ = error;
    is_abandoned_ = true;
  }

  // Ends all runs because the process ends, and waits until they have ended, but not for ever.
  static void end_all()
  {
    Process& p = process();
    p.ending_thread = std::this_thread::get_id();
    for (Python_run* run : p.runs)
      run->is_abandoned_ = true;
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(3);
    while (!p.runs.empty() && std::chrono::steady_clock::now() < limit) {
      const No_python_lock no_python_lock;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  // Calls `work`. Throws the exceptions of `work`, of the callables and of signals.
  template <class Function>
  void operator()(const Function& work)
  {
    Process& p = process();
    if (p.ending_thread != std::thread::id() && p.ending_thread != std::this_thread::get_id())
      throw_system_exit();
    Worker* worker = nullptr;
    if (p.idle.empty())
      worker = new Worker;
    else {
      worker = p.idle.back();
      p.idle.pop_back();
    }
    p.runs.insert(this);
    worker->start([&] {
      std::exception_ptr error;
      try {
        work();
      }
      catch (...) {
        error = std::current_exception();
      }
      const std::lock_guard<std::mutex> lock(mutex_);
      error_ = error;
      is_done_ = true;
      changed_.notify_one();
    });
    {
      const No_python_lock no_python_lock;
      wait();
    }
    p.runs.erase(this);
    p.idle.push_back(worker);
    if (is_abandoned_ && !error_of_python_)
      throw_system_exit();
    if (!error_of_python_ && !error_)
      report(fraction_); // the last one
    if (error_of_python_)
      std::rethrow_exception(error_of_python_);
    if (error_)
      std::rethrow_exception(error_);
  }
};

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_PYTHON_RUN_H

// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_WORKER_H
#define SPECTRAL_SEGMENTATION_PYTHON_WORKER_H

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace python {

// A thread that runs one task after another until the process ends. It must not be destroyed.
class Worker
{
  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> work_;

  void work()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return work_ != nullptr; });
      const std::function<void()> work = std::exchange(work_, nullptr);
      lock.unlock();
      work();
      lock.lock();
    }
  }

public:
  Worker() { std::thread([this] { work(); }).detach(); }

  // Starts a work, which must not throw. The last one must have ended.
  void start(std::function<void()> work)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work_ = std::move(work);
    changed_.notify_one();
  }
};

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_WORKER_H

// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_SIGNAL_HANDLERS_H
#define SEGMENT_MESH_SIGNAL_HANDLERS_H

#ifndef _WIN32
#include <pthread.h>
#include <signal.h>
#endif

#include <vector>

namespace segment_mesh {

// Keeps this thread from handling signals while this object lives.
class Signal_block
{
#ifdef _WIN32
public:
  Signal_block() {}
#else
  sigset_t before_;

public:
  Signal_block()
  {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }

  ~Signal_block() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
#endif
  Signal_block(const Signal_block&) = delete;
  Signal_block& operator=(const Signal_block&) = delete;
};

// Lets a signal that ends the program first call a function, as long as this object lives. The call
// is always in the thread that made the object: the function may use what that thread changes under
// `Signal_block` only. Writing to a closed pipe or a file that gets too large becomes an error.
// Signals that are ignored, as by nohup, or have handlers already stay so. Only one such object may
// live at a time.
class Signal_handlers
{
  typedef void (*Function)(void*);

#ifdef _WIN32
public:
  Signal_handlers(Function, void*) {}
#else
  static inline Function function_ = nullptr;
  static inline void* argument_ = nullptr;
  static inline pthread_t thread_;

  std::vector<int> replaced_;

  static void handle(int number)
  {
    if (!pthread_equal(pthread_self(), thread_)) {
      pthread_kill(thread_, number);
      return;
    }
    function_(argument_);
    signal(number, SIG_DFL);
    raise(number); // it ends the program when this handler returns
  }

  void replace(int number, void (*handler)(int))
  {
    struct sigaction action;
    if (sigaction(number, nullptr, &action) != 0 || (action.sa_flags & SA_SIGINFO) != 0 ||
        action.sa_handler != SIG_DFL)
      return;
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigfillset(&action.sa_mask);
    replaced_.push_back(number);
    sigaction(number, &action, nullptr);
  }

public:
  Signal_handlers(Function function, void* argument)
  {
    function_ = function;
    argument_ = argument;
    thread_ = pthread_self();
    for (int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGXCPU})
      replace(number, handle);
    for (int number : {SIGPIPE, SIGXFSZ})
      replace(number, SIG_IGN);
  }

  ~Signal_handlers()
  {
    for (int number : replaced_)
      signal(number, SIG_DFL);
  }
#endif
  Signal_handlers(const Signal_handlers&) = delete;
  Signal_handlers& operator=(const Signal_handlers&) = delete;
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_SIGNAL_HANDLERS_H

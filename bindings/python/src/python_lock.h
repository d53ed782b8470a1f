// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_PYTHON_LOCK_H
#define SPECTRAL_SEGMENTATION_PYTHON_PYTHON_LOCK_H

#include <pybind11/pybind11.h>

#include <chrono>
#include <thread>

namespace python {

namespace py = pybind11;

// Calls f(), a function of Python's that may wait for Python's lock. A daemon thread that waits for
// it while the process ends is unwound by Python. This would end in std::terminate() at the first
// destructor on the way. Therefore the thread waits here for the end of the process.
template <class Function>
auto call_python(const Function& f)
{
  try {
    return f();
  }
  catch (...) { // not even the unwinding of a thread goes on before the handler ends
    for (;;)
      std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

// Holds Python's lock.
class Python_lock
{
  py::gil_scoped_acquire lock_ = call_python([] { return py::gil_scoped_acquire(); });
};

// Gives Python's lock to other threads.
class No_python_lock
{
  PyThreadState* const state_ = PyEval_SaveThread();

public:
  No_python_lock() = default;
  No_python_lock(const No_python_lock&) = delete;
  ~No_python_lock()
  { call_python([this] { PyEval_RestoreThread(state_); }); }
};

// Calls a callable of Python. Throws the exception that it raises.
inline py::object call(const py::object& callable, const py::object& argument)
{
  PyObject* const result = call_python(
    [&] { return PyObject_CallFunctionObjArgs(callable.ptr(), argument.ptr(), nullptr); });
  if (!result)
    throw py::error_already_set();
  return py::reinterpret_steal<py::object>(result);
}

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_PYTHON_LOCK_H

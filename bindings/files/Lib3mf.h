// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_LIB3MF_H
#define SEGMENT_MESH_LIB3MF_H

#include <Model/COM/NMR_DLLInterfaces.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace segment_mesh {

// An object of lib3mf. Functions throw `std::runtime_error` if the library reports an error.
class Lib3mf
{
  struct Release
  {
    void operator()(NMR::PLib3MFBase* instance) const { NMR::lib3mf_release(instance); }
  };

  std::unique_ptr<NMR::PLib3MFBase, Release> instance_;

  explicit Lib3mf(NMR::PLib3MFBase* instance) : instance_(instance) {}

  template <class Result>
  static void check(Result result, NMR::PLib3MFBase* instance)
  {
    if (result == 0)
      return;
    LPCSTR message = nullptr;
    DWORD code;
    if (instance)
      NMR::lib3mf_getlasterror(instance, &code, &message);
    throw std::runtime_error(std::string("lib3mf reports ") + (message ? message : "an error"));
  }

public:
  Lib3mf() = default; // no object

  // Returns a new model.
  static Lib3mf model()
  {
    NMR::PLib3MFBase* result = nullptr;
    check(NMR::lib3mf_createmodel(&result), nullptr);
    return Lib3mf(result);
  }

  explicit operator bool() const { return instance_ != nullptr; }
  NMR::PLib3MFBase* get() const { return instance_.get(); }

  template <class Function, class... Arguments>
  void call(Function function, Arguments... arguments) const
  { check(function(get(), arguments...), get()); }

  // Returns the object that a function makes, whose last argument takes it.
  template <class Function, class... Arguments>
  Lib3mf made(Function function, Arguments... arguments) const
  {
    NMR::PLib3MFBase* result = nullptr;
    check(function(get(), arguments..., &result), get());
    return Lib3mf(result);
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_LIB3MF_H

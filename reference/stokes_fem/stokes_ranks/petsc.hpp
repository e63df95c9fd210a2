#pragma once

#include <petscksp.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace reference::stokes_fem {

/// Throws std::runtime_error with what PETSc says of an error code.
inline void check(PetscErrorCode error) {
  if (error == 0)
    return;
  const char* text = nullptr;
  PetscErrorMessage(error, &text, nullptr);
  throw std::runtime_error(std::string("PETSc: ") + (text != nullptr ? text : "unknown error"));
}

/// Owns a PETSc object.
template <class Handle, PetscErrorCode (*destroy)(Handle*)>
class Owned {
public:
  Owned() = default;
  ~Owned() { destroy(&handle_); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  operator Handle() const { return handle_; }
  /// For the functions that make one; what was there is given back.
  Handle* fresh() {
    destroy(&handle_);
    return &handle_;
  }

private:
  Handle handle_ = nullptr;
};

using OwnedVec = Owned<Vec, VecDestroy>;
using OwnedMat = Owned<Mat, MatDestroy>;
using OwnedKsp = Owned<KSP, KSPDestroy>;
using OwnedPc = Owned<PC, PCDestroy>;

} // namespace reference::stokes_fem

#pragma once

#include <abut/error.hpp>
#include <abut/triangle_mesh.hpp>

#include <utility>

namespace abut::python {

/// A mesh that Python may move, except while a call reads it. All members need the interpreter's
/// lock, which guards the count of readers.
class HeldMesh {
 public:
  explicit HeldMesh(TriangleMesh mesh) : mesh_(std::move(mesh)) {}
  HeldMesh(HeldMesh&&) = default;
  HeldMesh(const HeldMesh&) = delete;

  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }

  /// The mesh, to be changed without giving up the lock. Throws Error{wrong_usage} while a call in
  /// another thread, or further up in this one, reads it.
  [[nodiscard]] TriangleMesh& to_change() {
    if (readers_ == 0) return mesh_;
    throw Error(ErrorCode::wrong_usage,
                "a call in another thread, or further up in this one, reads this mesh; move it "
                "between the calls");
  }

  /// One call that reads the mesh while other threads of Python run.
  class Reading {
   public:
    explicit Reading(HeldMesh& held) : held_(held) { ++held_.readers_; }
    ~Reading() { --held_.readers_; }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

   private:
    HeldMesh& held_;
  };

 private:
  TriangleMesh mesh_;
  int readers_ = 0;
};

}  // namespace abut::python

// SPDX-License-Identifier: MIT
// The indices of a halfedge mesh, and arrays indexed by one kind of handle.
#pragma once

#include <cstddef>
#include <vector>

#include "base/handle.h"

namespace remesher {

using Vertex = Handle<struct VertexTag>;
using Halfedge = Handle<struct HalfedgeTag>;
using Face = Handle<struct FaceTag>;

// An array indexed by one kind of handle.
template <class H, class T>
class HandleData {
 public:
  HandleData() = default;
  explicit HandleData(std::size_t size) : data_(size) {}
  HandleData(std::size_t size, const T& value) : data_(size, value) {}

  decltype(auto) operator[](H handle) { return data_[handle.index]; }
  decltype(auto) operator[](H handle) const { return data_[handle.index]; }
  std::size_t size() const { return data_.size(); }
  void resize(std::size_t size) { data_.resize(size); }
  void resize(std::size_t size, const T& value) { data_.resize(size, value); }
  void assign(std::size_t size, const T& value) { data_.assign(size, value); }
  void reserve(std::size_t size) { data_.reserve(size); }
  std::vector<T>& values() { return data_; }
  const std::vector<T>& values() const { return data_; }

 private:
  std::vector<T> data_;
};

template <class T>
using VertexData = HandleData<Vertex, T>;
template <class T>
using HalfedgeData = HandleData<Halfedge, T>;
template <class T>
using FaceData = HandleData<Face, T>;

}  // namespace remesher

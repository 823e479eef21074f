// SPDX-License-Identifier: MIT
// Compiles tinygltf's implementation with our type of JSON, which keeps the order of names, since a
// second JSON type would be large. Two of the headers are there because tinygltf does not include
// them, or includes them hidden.
#include <fstream>
#include <string>
#include <type_traits>

#include "io/model/json.h"

// Replaces std inside tinygltf: the same, except for the streams that build its messages. The
// library's streams link in its locales, a fourteenth of our module.
namespace tinygltf::std {

using namespace ::std;

constexpr char endl = '\n';

class stringstream {
 public:
  template <class Part>
  stringstream& operator<<(const Part& part) {
    if constexpr (is_arithmetic_v<Part> && !is_same_v<Part, char>)
      text_ += to_string(part);
    else
      text_ += part;
    return *this;
  }

  const string& str() const { return text_; }

 private:
  string text_;
};

}  // namespace tinygltf::std

#define TINYGLTF_IMPLEMENTATION
#define json ordered_json
#include "io/gltf/library/tinygltf.h"

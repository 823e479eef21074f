// SPDX-License-Identifier: MIT
// tinygltf's implementation, which is compiled here, with the type of JSON that keeps the order of
// names, which is ours: a second one is large. Of the headers two are those that it forgets to
// include, or includes hidden.
#include <fstream>
#include <string>
#include <type_traits>

#include "io/model/json.h"

// What tinygltf calls std: the same, but for the streams that it puts its messages together in.
// Those of the library bring its locales along, a fourteenth of our module.
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

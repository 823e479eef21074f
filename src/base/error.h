// SPDX-License-Identifier: MIT
// The one exception that remesher throws: the input or request cannot be processed, for a reason
// said in one sentence. The error codes are listed here only: the bindings hand the list to
// JavaScript, where a test compares it.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace remesher {

enum class ErrorCode {
  Internal,           // our fault
  Cancelled,          // the caller asked to stop
  OutOfMemory,        // the machine's limit
  InvalidOption,      // an option's value is out of range, or two contradict each other
  UnknownOption,      // no option has this name
  UnknownFormat,      // neither extension nor content is one we read or write
  EmptyFile,          // no bytes
  ParseError,         // the bytes are not what the format promises
  MissingResource,    // a file refers to another that was not given
  Unsupported,        // valid, but beyond what we read
  InvalidMesh,        // arrays of the wrong type or length, or no closed body
  IndexOutOfRange,    // a triangle names a vertex that is not there
  NonFinite,          // NaN or infinity among the coordinates
  NoTriangles,        // nothing to remesh
  TargetTooSmall,     // fewer vertices asked for than the surface needs
  TargetBelowCurves,  // fewer vertices asked for than the feature curves need
  InputUnreadable,    // command line: cannot open the input
  OutputUnwritable,   // command line: cannot write the output
};

// In the order of ErrorCode.
inline constexpr std::array<std::string_view, 18> kErrorCodeNames = {
    "INTERNAL",         "CANCELLED",        "OUT_OF_MEMORY",    "INVALID_OPTION",
    "UNKNOWN_OPTION",   "UNKNOWN_FORMAT",   "EMPTY_FILE",       "PARSE_ERROR",
    "MISSING_RESOURCE", "UNSUPPORTED",      "INVALID_MESH",     "INDEX_OUT_OF_RANGE",
    "NON_FINITE",       "NO_TRIANGLES",     "TARGET_TOO_SMALL", "TARGET_BELOW_CURVES",
    "INPUT_UNREADABLE", "OUTPUT_UNWRITABLE"};

constexpr std::string_view name(ErrorCode code) {
  return kErrorCodeNames[static_cast<std::size_t>(code)];
}

// message: the fault and its place. hint: a way out of it; may be empty.
struct Error : std::runtime_error {
  Error(ErrorCode errorCode, const std::string& message, std::string whatToDo = {})
      : std::runtime_error(message), code(errorCode), hint(std::move(whatToDo)) {}

  ErrorCode code;
  std::string hint;
};

}  // namespace remesher

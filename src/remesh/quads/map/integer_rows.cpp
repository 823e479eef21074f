// SPDX-License-Identifier: MIT
#include "remesh/quads/map/integer_rows.h"

#include <cstdlib>
#include <numeric>

namespace remesher {

namespace {

void divideByCommon(IntegerSum& sum) {
  int common = 0;
  for (const auto& [variable, coefficient] : sum) common = std::gcd(common, coefficient);
  if (common > 1)
    for (auto& [variable, coefficient] : sum) coefficient /= common;
}

}  // namespace

IntegerSum plus(const IntegerSum& a, const IntegerSum& b, int factor) {
  IntegerSum sum;
  sum.reserve(a.size() + b.size());
  std::size_t i = 0, k = 0;
  while (i < a.size() || k < b.size()) {
    const bool isOfA = k == b.size() || (i < a.size() && a[i].first <= b[k].first);
    const bool isOfB = i == a.size() || (k < b.size() && b[k].first <= a[i].first);
    const Index variable = isOfA ? a[i].first : b[k].first;
    const int coefficient = (isOfA ? a[i++].second : 0) + (isOfB ? factor * b[k++].second : 0);
    if (coefficient != 0) sum.emplace_back(variable, coefficient);
  }
  return sum;
}

// The highest defined variable is replaced first: definitions express higher variables by lower
// ones, where they can.
IntegerSum IntegerRows::reduced(IntegerSum sum) const {
  for (std::size_t i = sum.size(); i > 0;) {
    const auto [variable, coefficient] = sum[i - 1];
    if (!isDefined_[variable]) {
      --i;
      continue;
    }
    sum.erase(sum.begin() + std::ptrdiff_t(i) - 1);
    sum = plus(sum, definition_[variable], coefficient);
    i = sum.size();
  }
  return sum;
}

bool IntegerRows::add(const IntegerSum& equation) {
  IntegerSum sum = reduced(equation);
  if (sum.empty()) return true;
  divideByCommon(sum);
  // Real variables come last, so that one of them is taken if there is any.
  std::size_t pivot = sum.size();
  while (pivot > 0 && std::abs(sum[pivot - 1].second) != 1) --pivot;
  if (pivot == 0) return false;
  const auto [variable, coefficient] = sum[pivot - 1];
  const bool isWhole = variable < whole_;
  if (isWhole && sum.back().first >= whole_) return false;
  sum.erase(sum.begin() + std::ptrdiff_t(pivot) - 1);
  definition_[variable] = plus({}, sum, -coefficient);
  isDefined_[variable] = 1;
  order_.push_back(variable);
  return true;
}

// The last definition has only free variables; each before it has free variables or later ones.
void IntegerRows::resolve() {
  for (std::size_t i = order_.size(); i > 0; --i) {
    const Index variable = order_[i - 1];
    definition_[variable] = reduced(std::move(definition_[variable]));
  }
}

}  // namespace remesher

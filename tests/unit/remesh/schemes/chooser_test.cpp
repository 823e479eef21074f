// SPDX-License-Identifier: MIT
#include "remesh/schemes/chooser.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace remesher;

namespace {

bool isUnconditional(const Rule& rule) {
  return std::all_of(rule.when.begin(), rule.when.end(),
                     [](const Condition& c) { return c.fact == Fact::Always; });
}

// The facts that the rows of a decision ask for.
std::vector<Fact> factsOf(Decision decision) {
  std::set<Fact> facts;
  for (const Rule& row : chooserRules())
    for (const Condition& c : row.when)
      if (row.decision == decision && c.fact != Fact::Always) facts.insert(c.fact);
  return {facts.begin(), facts.end()};
}

bool isMet(const Rule& row, const std::map<Fact, bool>& answers) {
  return std::all_of(row.when.begin(), row.when.end(), [&](const Condition& c) {
    return c.fact == Fact::Always || answers.at(c.fact) == c.holds;
  });
}

}  // namespace

TEST_CASE("chooser: for all answers the first row is taken whose conditions hold, each for some") {
  std::set<const Rule*> taken;
  for (const Rule& first : chooserRules()) {
    if (taken.contains(&first)) continue;
    const std::vector<Fact> facts = factsOf(first.decision);
    for (std::size_t bits = 0; bits < std::size_t{1} << facts.size(); ++bits) {
      std::map<Fact, bool> answers;
      for (std::size_t i = 0; i < facts.size(); ++i) answers[facts[i]] = (bits >> i & 1) != 0;
      const Rule* const row = &choose(first.decision, [&](Fact f) { return answers.at(f); });
      taken.insert(row);
      const bool isFirst = std::none_of(chooserRules().data(), row, [&](const Rule& above) {
        return above.decision == first.decision && isMet(above, answers);
      });
      if (!isMet(*row, answers) || !isFirst) FAIL(std::string(row->name));
    }
  }
  for (const Rule& row : chooserRules()) {
    CAPTURE(std::string(row.name));
    CHECK(taken.contains(&row));
  }
}

TEST_CASE("chooser: each decision ends with a row without conditions, and no other row is one") {
  const auto rules = chooserRules();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const bool isLast = i + 1 == rules.size() || rules[i + 1].decision != rules[i].decision;
    CHECK(isUnconditional(rules[i]) == isLast);
  }
}

TEST_CASE("chooser: rows of a decision stand together, and have names and sentences of their own") {
  std::set<std::pair<Decision, std::string_view>> names;
  std::vector<Decision> decisions;
  for (const Rule& row : chooserRules()) {
    CHECK(names.emplace(row.decision, row.name).second);
    CHECK(row.reason.ends_with('.'));
    if (decisions.empty() || decisions.back() != row.decision) decisions.push_back(row.decision);
  }
  CHECK(std::set(decisions.begin(), decisions.end()).size() == decisions.size());
}

TEST_CASE("chooser: no fact is asked for that an earlier condition makes unnecessary") {
  std::vector<Fact> asked;
  choose(Decision::Surface, [&](Fact fact) {
    asked.push_back(fact);
    return fact == Fact::VerticesPlaced;
  });
  CHECK(asked == std::vector{Fact::RoundsAsked, Fact::IsotropicAsked, Fact::VerticesPlaced});
}

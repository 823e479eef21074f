// SPDX-License-Identifier: MIT
// No room, no file and no function has outgrown its reader.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { constantsIn, withConstant } from '../support/constants.js';
import { cppFunctions } from '../support/cpp_functions.js';
import { engineList, engines, headerOf } from '../support/engines.js';
import {
  filesWithSizes, folderSizes, jsFunctions, limits, shareOfLong,
} from '../support/figures.js';
import { readText, root } from '../support/tree.js';

const sources = ['src', 'bindings', 'web'].flatMap(filesWithSizes);
const files = [...sources, ...filesWithSizes('tests')];
const functions = files.flatMap((file) => file.functions.map((one) =>
  ({ ...one, where: `${file.path}:${one.line} ${one.name}` })));

test('functions of C++ are found, with their lines and parameters', () => {
  const text = `#include "a.h"
namespace n {  // "{"
enum class E { A, B };
constexpr int kTable[2] = {1, 2};

template <class T, std::size_t n>
T first(const std::array<T, n>& values, int from = int(')')) {
  for (const T& value : values)
    if (value > T{}) return value;
  return {};
}

class C : public B<int, int> {
 public:
  explicit C(int a, std::function<void(int, int)> b = {})
      : a_{a}, b_(b) {}
  bool operator()(int x) const { return [](int y, int z) { return y < z; }(x, 1'000); }
  operator bool() const;

 private:
  int a_{0};
};

C::operator bool() const {
  return "}" != nullptr && a_ == '}';
}
}  // namespace n
`;
  assert.deepEqual(cppFunctions(text), [
    { name: 'first', line: 6, lines: 6, parameters: 2 },
    { name: 'C', line: 15, lines: 2, parameters: 2 },
    { name: 'operator()', line: 17, lines: 1, parameters: 1 },
    { name: 'operator bool', line: 24, lines: 3, parameters: 0 },
  ]);
});

test('functions of JavaScript are found by their names', () => {
  const text = `#!/usr/bin/env node
export function plain(a, { b }) {
  return [a].map((x) => x + b);
}
const arrow = () => 1;
class C {
  #own = () => arrow();
  get it() {
    return this.#own();
  }
}
new C();
`;
  assert.deepEqual(jsFunctions(text), [
    { name: 'plain', line: 2, lines: 3, parameters: 2 },
    { name: 'arrow', line: 5, lines: 1, parameters: 0 },
    { name: 'own', line: 7, lines: 1, parameters: 0 },
    { name: 'it', line: 8, lines: 3, parameters: 0 },
  ]);
  assert.throws(() => jsFunctions('function ('), /line 1/);
});

test(`a folder has at most ${limits.modules} modules`, () => {
  const wrong = [...folderSizes(sources)].filter(([, { modules }]) => modules > limits.modules);
  assert.deepEqual(wrong, []);
});

test(`a file has at most ${limits.fileLines} lines`, () => {
  const wrong = files.filter(({ lines }) => lines > limits.fileLines).map(({ path }) => path);
  assert.deepEqual(wrong, []);
});

test(`a function has at most ${limits.functionLines} lines`, () => {
  const wrong = functions.filter(({ lines }) => lines > limits.functionLines);
  assert.deepEqual(wrong.map(({ where }) => where), []);
});

test(`most functions have at most ${limits.habit} lines`, () => {
  for (const top of ['src', 'bindings', 'web', 'tests']) {
    const own = functions.filter(({ where }) => where.startsWith(`${top}/`));
    assert.ok(own.length > 100, `${top} has functions`);
    assert.ok(shareOfLong(own) <= limits.longFunctions, `${top}: ${shareOfLong(own)}`);
  }
});

test(`a function has at most ${limits.parameters} parameters`, () => {
  const wrong = functions.filter(({ parameters }) => parameters > limits.parameters);
  assert.deepEqual(wrong.map(({ where }) => where), []);
});

test('src/README.md names the engines of a kind, and each is there', () => {
  assert.ok(readText('src/README.md').includes(engineList()), 'npm run figures prints the list');
  const missing = engines.flatMap((kind) => kind.files).map(headerOf)
    .filter((file) => !existsSync(join(root, file)));
  assert.deepEqual(missing, []);
});

test('constants are found, several to a statement, and no calls or mentions', () => {
  assert.deepEqual(constantsIn(`constexpr double kOne = 1, kTwo = 2.5;  // not kThree = 3
    inline constexpr Effort kRow = {1, 2}; const double kFour = std::cos(kOne);
    if (x == kOne) return kTwo + f(kOne); static constexpr int kFive{5};`),
  ['kOne', 'kTwo', 'kRow', 'kFour', 'kFive']);
});

test('a named constant gets another value where it is defined, and nowhere else', () => {
  const text = `// kOne = 0
constexpr double kOne = 1, kTwo = 2.5;
if (x == kOne) return kTwo + f(kOne); static constexpr int kFive{5};`;
  assert.equal(withConstant(text, 'kOne', '7'), text.replace('kOne = 1', 'kOne = 7'));
  assert.equal(withConstant(text, 'kTwo', '7'), text.replace('2.5', '7'));
  assert.equal(withConstant(text, 'kFive', '7'), text.replace('{5}', '{7}'));
  assert.equal(withConstant(text, 'kSix', '7'), undefined);
  assert.equal(withConstant(`${text}\nconstexpr int kOne = 3;`, 'kOne', '7'), undefined);
});

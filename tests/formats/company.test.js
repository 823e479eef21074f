// SPDX-License-Identifier: MIT
// Files are compiled as one only where they can be.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { definedNames, inCompany, innerConstants, renamed } from '../support/company.js';

const text = `#include "a.h"
namespace remesher {
namespace {
constexpr double kGood = angle(25), kBad = angle(3),
                 kWorst = 1;
struct Soup {
  int notMine = 0;
};
using Row = std::vector<int>;
template <class T>
std::vector<Soup> boil(const Soup& soup, int times) {
  return helper(soup);
}
}  // namespace
void Pot::stir(int times) {}
}  // namespace remesher
`;

test('the names are those outside of functions and classes', () => {
  assert.deepEqual(definedNames(text),
    ['kGood', 'Soup', 'Row', 'boil(const Soup&,int)', 'kBad', 'kWorst']);
});

test('a type goes by its own name, not by what it is made of', () => {
  assert.deepEqual(definedNames('enum class Side : unsigned char {\n};\nstruct A : B {\n};\n'),
    ['Side', 'A']);
});

test('what no header speaks of, nor any member is called, has a name of its own in company', () => {
  const more = `#include "kitchen/boil.h"
void salt(Soup soup) {
  stir(boil<Row>(kGood, soup.salt), kGoodSoup);
}
`;
  const other = renamed('src/big_room/pot.cpp', text + more, 'struct Table {\n  int Row;\n};\n');
  assert.deepEqual(definedNames(other), ['kGoodOfSrcBigRoomPot', 'SoupOfSrcBigRoomPot', 'Row',
    'boilOfSrcBigRoomPot(const SoupOfSrcBigRoomPot&,int)', 'salt(SoupOfSrcBigRoomPot)',
    'kBadOfSrcBigRoomPot', 'kWorstOfSrcBigRoomPot']);
  assert.ok(other.endsWith(`#include "kitchen/boil.h"
void salt(SoupOfSrcBigRoomPot soup) {
  stir(boilOfSrcBigRoomPot<Row>(kGoodOfSrcBigRoomPot, soup.salt), kGoodSoup);
}
`));
  assert.equal(renamed('src/pot.cpp', 'void Pot::stir(int times) {}\n', ''),
    'void Pot::stir(int times) {}\n');
});

test('functions of one name are one if their parameters have the same types', () => {
  const own = (parameters) => definedNames(`int stir(${parameters}) {}\n`).join();
  assert.equal(own('const Pot& pot,\n         std::map<int, int> times = {}'),
    own('const Pot& other, std::map<int, int> many'));
  assert.equal(own('std::string_view text'), own('const std::string& bytes'));
  assert.notEqual(own('Pot pot'), own('Pot& pot'));
  assert.notEqual(own('int times'), own(''));
});

test('files that define one name are apart, those with macros alone', () => {
  const files = { a: 'int one() {}\n', b: 'int two() {}\n', c: 'int one() {}\nint two() {}\n',
    d: '#define MACRO\nint three() {}\n' };
  assert.deepEqual(inCompany(Object.keys(files), (file) => files[file], () => []),
    [['d'], ['a', 'b'], ['c']]);
});

test('a file that defines what a header of another does is apart, in either order', () => {
  const types = { a: ['Run'], b: ['Run'], c: [] };
  const texts = { a: 'int one() {}\n', b: 'int two() {}\n', c: 'struct Run {};\n' };
  const groups = (/** @type {string[]} */ files) =>
    inCompany(files, (file) => texts[file], (file) => types[file]);
  assert.deepEqual(groups(['a', 'b', 'c']), [['a', 'b'], ['c']]);
  assert.deepEqual(groups(['c', 'b', 'a']), [['c'], ['b', 'a']]);
});

test('constants within functions are found, and no others', () => {
  const inner = 'void stir() {\n  constexpr double kSpeed = 2;\n  int times = kSpeed;\n}\n';
  assert.deepEqual(innerConstants(text + inner), ['kSpeed']);
});

test('no company is too large, all are of like size, and each file is in one', () => {
  const files = Array.from({ length: 250 }, (_, i) => `f${i}`);
  const groups = inCompany(files, (file) => `int ${file}();\n`, () => []);
  assert.deepEqual(groups.flat(), files);
  assert.deepEqual(groups.map(({ length }) => length), [125, 125]);
});

test('a file that cannot go where there is room goes to another company', () => {
  const files = Array.from({ length: 150 }, (_, i) => `f${i}`);
  const textOf = (/** @type {string} */ file) =>
    `int ${['f80', 'f149'].includes(file) ? 'one' : file}();\n`;
  const groups = inCompany(files, textOf, () => []);
  assert.deepEqual(groups.map((group) => [group.length, group.includes('f149')]),
    [[76, true], [74, false]]);
});

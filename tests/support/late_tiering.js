// SPDX-License-Identifier: MIT
// Loaded first by every program of Node's that tests start: V8 optimises a function of WebAssembly
// once it has run fifty times as long as usual. Most programs of tests run shorter than it takes to
// optimise what they call.
import { setFlagsFromString } from 'node:v8';

setFlagsFromString('--wasm-tiering-budget=100000000');

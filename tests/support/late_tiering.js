// SPDX-License-Identifier: MIT
// Every Node program that tests start loads this file first. V8 then optimizes a WebAssembly
// function after fifty times the usual running time: most test programs are shorter than the
// optimization of the functions that they call.
import { setFlagsFromString } from 'node:v8';

setFlagsFromString('--wasm-tiering-budget=100000000');

// SPDX-License-Identifier: MIT
// The type of the module that Emscripten makes; engine.js alone knows what is in an instance.
export default function createInstance(options: {
  instantiateWasm(
    imports: WebAssembly.Imports,
    use: (instance: WebAssembly.Instance) => void,
  ): object;
}): Promise<any>;

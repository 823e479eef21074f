// SPDX-License-Identifier: MIT
// Builds the page and serves it on this computer: node web/serve.js [port]. PORT works, too; a port
// that is taken makes it try the next.
import { build, preview } from 'vite';

const configFile = new URL('./vite.config.js', import.meta.url).pathname;
const port = Number(process.argv[2] ?? process.env.PORT ?? 8080);

console.log('Building the page');
await build({ configFile, logLevel: 'warn' });
const server = await preview({ configFile, logLevel: 'warn', preview: { port } });
console.log(`remesher is ready at ${server.resolvedUrls?.local[0]} (stop with Ctrl+C)`);

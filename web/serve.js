// SPDX-License-Identifier: MIT
// Builds the page, with the documentation if that exists, and serves both on this computer:
// node web/serve.js [port]. The variable PORT works, too; if the port is taken, the next is tried.
import { preview } from 'vite';
import { buildSite, configFile } from './site.js';

const port = Number(process.argv[2] ?? process.env.PORT ?? 8080);

await buildSite();
const server = await preview({ configFile, logLevel: 'warn', preview: { port } });
console.log(`remesher is ready at ${server.resolvedUrls?.local[0]} (stop with Ctrl+C)`);

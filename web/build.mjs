// Bundles src/ into a C++ file that carries it: node build.mjs MODULES OUT.cpp
// MODULES is the folder in which `npm ci` was run.
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const [modules, out] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(modules, 'package.json'))('esbuild');
const licence = readFileSync(join(modules, 'node_modules/uplot/LICENSE'), 'utf8').trim();

const result = await esbuild.build({
  entryPoints: [join(here, 'src/main.js')],
  bundle: true,
  minify: true,
  write: false,
  outdir: dirname(out),
  format: 'iife',
  target: ['chrome104', 'firefox113', 'safari16.4'],
  charset: 'ascii',
  legalComments: 'none',
  banner: {js: `/*\nCurves by uPlot:\n${licence}\n*/`},
  nodePaths: [join(modules, 'node_modules')],
  logLevel: 'warning',
});

/** The bytes of a file that ends like this, as numbers. */
function numbers(ending) {
  const file = result.outputFiles.find(({path}) => path.endsWith(ending));
  if (/<\/(script|style)/i.test(file.text)) throw new Error(`${ending}: holds an end of its own tag`);
  return Array.from(file.contents).join(',').replace(/(.{1,110},)/g, '$1\n');
}

writeFileSync(out, `// Made by web/build.mjs from web/src.
#include "tools/report/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

constexpr char kScript[] = {${numbers('.js')}};
constexpr char kStyle[] = {${numbers('.css')}};

}  // namespace

std::optional<WebBundle> web_bundle() {
  return WebBundle{{kScript, sizeof kScript}, {kStyle, sizeof kStyle}};
}

}  // namespace castaway::testbed
`);

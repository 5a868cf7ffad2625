// Bundles src/ into a C++ file that carries it: node build.mjs MODULES OUT.cpp
// MODULES is the folder in which `npm ci` was run.
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename, dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const [modules, out] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(modules, 'package.json'))('esbuild');
const licenceOf = (name) =>
  readFileSync(join(modules, `node_modules/${name}/LICENSE`), 'utf8').trim().replaceAll('\u00a9', '(c)');

const result = await esbuild.build({
  entryPoints: {player: join(here, 'src/main.js'), plots: join(here, 'src/plots_main.js'),
    campaign: join(here, 'src/campaign_main.js'), live: join(here, 'src/live_main.js')},
  bundle: true,
  minify: true,
  write: false,
  outdir: dirname(out),
  format: 'iife',
  target: ['chrome104', 'firefox113', 'safari16.4'],
  charset: 'ascii',
  legalComments: 'none',
  banner: {js: `/*\nCurves by uPlot:\n${licenceOf('uplot')}\n\n3-D view by three.js:\n${licenceOf('three')}\n*/`},
  nodePaths: [join(modules, 'node_modules')],
  logLevel: 'warning',
});

/** The bytes of a bundle's file, as numbers. */
function numbers(name) {
  const file = result.outputFiles.find(({path}) => basename(path) === name);
  if (/<\/(script|style)/i.test(file.text)) throw new Error(`${name}: holds an end of its own tag`);
  return Array.from(file.contents).join(',').replace(/(.{1,110},)/g, '$1\n');
}

writeFileSync(out, `// Made by web/build.mjs from web/src.
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

constexpr char kPlayer[] = {${numbers('player.js')}};
constexpr char kPlayerStyle[] = {${numbers('player.css')}};
constexpr char kPlots[] = {${numbers('plots.js')}};
constexpr char kPlotsStyle[] = {${numbers('plots.css')}};
constexpr char kCampaign[] = {${numbers('campaign.js')}};
constexpr char kCampaignStyle[] = {${numbers('campaign.css')}};
constexpr char kLive[] = {${numbers('live.js')}};
constexpr char kLiveStyle[] = {${numbers('live.css')}};

}  // namespace

std::optional<WebBundle> player_bundle() {
  return WebBundle{{kPlayer, sizeof kPlayer}, {kPlayerStyle, sizeof kPlayerStyle}};
}

std::optional<WebBundle> plots_bundle() {
  return WebBundle{{kPlots, sizeof kPlots}, {kPlotsStyle, sizeof kPlotsStyle}};
}

std::optional<WebBundle> campaign_bundle() {
  return WebBundle{{kCampaign, sizeof kCampaign}, {kCampaignStyle, sizeof kCampaignStyle}};
}

std::optional<WebBundle> live_bundle() {
  return WebBundle{{kLive, sizeof kLive}, {kLiveStyle, sizeof kLiveStyle}};
}

}  // namespace castaway::testbed
`);

// axe-core in a page: what it finds that keeps people from using the page.
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

const kGrave = ['moderate', 'serious', 'critical'];

/** The source of axe-core; `modules`: the folder in which `npm ci` was run. */
export function axeSource(modules) {
  return readFileSync(join(modules, 'node_modules/axe-core/axe.min.js'), 'utf8');
}

/** Violations of the open page of impact moderate and above, a line an element. */
export async function graveViolations(browser, source) {
  await browser.evaluate(`${source}; void 0`);
  const violations = await browser.evaluate(`axe.run(document, {resultTypes: ['violations']})
    .then(({violations}) => violations.map(({id, impact, nodes}) => ({id, impact,
      nodes: nodes.map(({target, failureSummary}) => [target.join(' '), failureSummary])})))`);
  return violations.filter(({impact}) => kGrave.includes(impact)).flatMap(({id, impact, nodes}) =>
    nodes.map(([target, summary]) => `${impact}: ${id}: ${target}: ${summary.replace(/\s+/g, ' ')}`));
}

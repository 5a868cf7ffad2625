// Draws the plots that the page describes; see plot_spec.js.
import {element} from './dom.js';
import {palette} from './palette.js';
import {addPlot, widthIn} from './plot.js';
import {drawMarks} from './plot_marks.js';
import {complete, isEmpty} from './plot_spec.js';

const kHeights = {wide: 210, pairs: 300};  // [px]

function addNothing(place, {title, nothing}) {
  place.append(element('figure', {}, element('figcaption', {}, title), element('p', {class: 'soft'}, nothing)));
}

/** Draws all plots. Returns a function that takes the theme's colours anew. */
export function drawPlots() {
  let colors = palette();
  const drawn = [];
  for (const place of document.querySelectorAll('.plots')) {
    const {x, plots} = JSON.parse(place.nextElementSibling.textContent);
    const height = place.classList.contains('pairs') ? kHeights.pairs : kHeights.wide;
    for (const plot of plots.map((one) => complete(one, x))) {
      if (plot.nothing && isEmpty(plot)) {
        addNothing(place, plot);
        continue;
      }
      const marks = (plot.marks ?? []).map((time) => ({time, color: 'mark'}));
      drawn.push(addPlot(place, plot, height, () => colors, {draw: (made) => drawMarks(made, marks, colors)}));
    }
    new ResizeObserver(() => drawn.forEach((plot) => fit(plot))).observe(place);
  }
  return () => {
    colors = palette();
    for (const plot of drawn) plot.redraw(false, true);
  };
}

function fit(plot) {
  const width = widthIn(plot.root.parentElement);
  if (plot.width !== width) plot.setSize({width, height: plot.height});
}

// Plots that change with a choice: one figure of many, one key of several.
import {element} from './dom.js';
import {curvesPlot, figureGroups, firstFigure} from './campaign_plots.js';
import {addPlot, widthIn} from './plot.js';
import {complete, isEmpty} from './plot_spec.js';

const kHeight = 280;  // [px]

/**
 * Plots below a choice. `options`: names; `groups`: of them, as figureGroups has them, or null; `plotsOf(i)`: descriptions.
 * Returns a function that recolours them.
 */
function addChoice(place, title, {options, groups = null, chosen}, plotsOf, colors) {
  const option = (name) => element('option', {value: String(options.indexOf(name))}, name);
  const select = element('select', {change: () => draw()}, ...(groups === null ? options.map(option)
    : groups.map(([label, names]) => element('optgroup', {label}, ...names.map(option)))));
  select.value = String(chosen);
  const plots = element('div', {class: 'plots pairs'});
  place.append(element('p', {class: 'choices'}, element('label', {}, `${title} `, select)), plots);
  let drawn = [];
  function draw() {
    for (const plot of drawn) plot.destroy();
    drawn = [];
    plots.replaceChildren();
    for (const plot of plotsOf(Number(select.value)).map((one) => complete(one))) {
      if (isEmpty(plot)) {
        plots.append(element('figure', {}, element('figcaption', {}, plot.title),
          element('p', {class: 'soft'}, plot.nothing)));
      } else {
        drawn.push(addPlot(plots, plot, kHeight, colors));
      }
    }
  }
  draw();
  new ResizeObserver(() => {
    for (const plot of drawn) {
      const width = widthIn(plot.root.parentElement);
      if (plot.width !== width) plot.setSize({width, height: plot.height});
    }
  }).observe(plots);
  return () => drawn.forEach((plot) => plot.redraw(false, true));
}

function dataOf(place) {
  return JSON.parse(place.nextElementSibling.textContent);
}

/** Curves of every figure over every key, and survival curves. Returns functions that recolour them. */
export function addChoices(colors) {
  const recolors = [];
  for (const place of document.querySelectorAll('.campaign-curves')) {
    const data = dataOf(place);
    const plots = (figure) => data.axes.map((axis) => curvesPlot(data, axis, figure));
    recolors.push(addChoice(place, 'Figure', {options: data.names, groups: figureGroups(data.names),
      chosen: firstFigure(data.names)}, plots, colors));
  }
  for (const place of document.querySelectorAll('.campaign-recovery')) {
    const groups = dataOf(place);
    recolors.push(addChoice(place, 'By', {options: groups.map(({name}) => name), chosen: 0}, (i) => groups[i].plots,
      colors));
  }
  return recolors;
}

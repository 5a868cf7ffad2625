// Starts the page of a campaign.
import 'uplot/dist/uPlot.min.css';
import './plots.css';
import './campaign.css';
import {addChoices} from './campaign_choices.js';
import {addHeatChoices} from './heat_maps.js';
import {palette} from './palette.js';
import {addTables} from './tables.js';

let colors = palette();
const recolors = addChoices(() => colors);
addTables();
addHeatChoices();
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
  colors = palette();
  for (const recolor of recolors) recolor();
});

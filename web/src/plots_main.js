// Starts the plots of a page without a player.
import 'uplot/dist/uPlot.min.css';
import './plots.css';
import {drawPlots} from './plots.js';

const recolor = drawPlots();
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolor);

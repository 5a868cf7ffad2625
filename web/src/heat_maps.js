// Which layer of the heat maps is shown, and what its colours say.

/** Makes the choices of every group of heat maps work. */
export function addHeatChoices() {
  for (const maps of document.querySelectorAll('.heat-maps')) {
    const series = maps.querySelector('.heat-series');
    const measure = maps.querySelector('.heat-measure');
    const show = () => {
      maps.className = `heat-maps by-${measure.value}`;
      for (const layer of maps.querySelectorAll('.heat')) {
        layer.style.display = layer.dataset.series === series.value ? '' : 'none';
      }
    };
    series.addEventListener('change', show);
    measure.addEventListener('change', show);
    maps.querySelector('.choices').hidden = false;
    show();
  }
}

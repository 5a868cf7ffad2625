// What the 3-D view shows.

/** An expression: of the 3-D view's pixels the number of different colours, and one number for all of them. */
export const kPixels3d = `(() => {
  const shown = document.querySelector('canvas.view-3d');
  const copy = Object.assign(document.createElement('canvas'), {width: shown.width, height: shown.height});
  const context = copy.getContext('2d', {willReadFrequently: true});
  context.drawImage(shown, 0, 0);
  const data = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
  let sum = 0;
  for (const pixel of data) sum = (sum * 31 + pixel) % 4294967291;
  return {colors: new Set(data).size, sum};
})()`;

/** An expression: a promise that the 3-D view, once drawn, stands still for some time. */
export const kStill3d = `(async () => {
  const count = () => Number(document.querySelector('canvas.view-3d').dataset.drawn ?? 0);
  for (let still = 0, last = -1; still < 6 || last < 1;) {
    await new Promise((resolve) => setTimeout(resolve, 50));
    still = count() === last ? still + 1 : 0;
    last = count();
  }
})()`;

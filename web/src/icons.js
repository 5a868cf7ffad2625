// Pictures on buttons: drawn, since fonts lack them here and there.

const kPaths = {
  play: 'M7 4v16l13-8z',
  pause: 'M6 4h4v16H6zM14 4h4v16h-4z',
  back: 'M15 5v14L5 12zM17 5h2v14h-2z',
  on: 'M9 5v14l10-7zM5 5h2v14H5z',
  first: 'M20 5v14l-8-7zM12 5v14l-8-7zM2 5h2v14H2z',
  last: 'M4 5v14l8-7zM12 5v14l8-7zM20 5h2v14h-2z',
  closer: 'M11 4h2v7h7v2h-7v7h-2v-7H4v-2h7z',
  farther: 'M4 11h16v2H4z',
  whole: 'M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z',
  above: 'M12 2l7 4v4l-7-4-7 4V6zM12 9l2.6 1.5V15H17l-5 6-5-6h2.4v-4.5z',
  follow: 'M11 2h2v4h-2zM11 18h2v4h-2zM2 11h4v2H2zM18 11h4v2h-4zM12 7a5 5 0 1 1 0 10a5 5 0 1 1 0-10z' +
    'M12 9.5a2.5 2.5 0 1 0 0 5a2.5 2.5 0 1 0 0-5z',
};

/** A picture of the colour of the text about it. */
export function icon(name) {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 24 24');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', kPaths[name]);
  path.setAttribute('fill', 'currentColor');
  path.setAttribute('fill-rule', 'evenodd');
  svg.append(path);
  return svg;
}

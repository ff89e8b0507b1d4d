# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests ask pages: expressions of JavaScript."""

# Texts of plots that extend beyond their drawing, or overlap another text of it.
CLASHES = """(() => {
  const found = [];
  for (const svg of document.querySelectorAll('svg.plot')) {
    const frame = svg.getBoundingClientRect();
    const texts = [...svg.querySelectorAll('text')].map(t => [t, t.getBoundingClientRect()]);
    for (const [t, r] of texts)
      if (r.left < frame.left - 1 || r.right > frame.right + 1 || r.top < frame.top - 1 || r.bottom > frame.bottom + 1)
        found.push('cut: ' + t.textContent + ' in ' + svg.getAttribute('aria-label'));
    for (const [i, [t, r]] of texts.entries())
      for (const [u, q] of texts.slice(i + 1))
        if (Math.min(r.right, q.right) - Math.max(r.left, q.left) > 2 &&
            Math.min(r.bottom, q.bottom) - Math.max(r.top, q.top) > 5)
          found.push(t.textContent + ' upon ' + u.textContent + ' in ' + svg.getAttribute('aria-label'));
  }
  return found;
})()"""

# Plots that have dots and no curve.
DOTS = """[...document.querySelectorAll('svg.plot')].filter(plot => {
  const curves = [...plot.querySelectorAll('path.curve')].map(c => c.getAttribute('d'));
  return curves.length > 0 && curves.every(d => /^M[^ML]*h0$/.test(d));
}).map(plot => plot.getAttribute('aria-label'))"""

# Wide tables that leave their box, or whose first column does not stay in sight at their other end.
TABLES = """(() => {
  const found = [];
  for (const box of document.querySelectorAll('.scroll')) {
    const frame = box.getBoundingClientRect();
    if (frame.left < 0 || frame.right > innerWidth) found.push('a box from ' + frame.left + ' to ' + frame.right);
    box.scrollLeft = 1e6;
    for (const row of box.querySelectorAll('.wide tr')) {
      const [first, last] = [row.cells[0], row.cells[row.cells.length - 1]].map(c => c.getBoundingClientRect());
      if (Math.abs(first.left - frame.left) > 1) found.push('out of sight: ' + row.cells[0].textContent);
      if (row.cells.length > 1 && first.right > last.left + 1) found.push('covers the last column: ' + row.textContent);
      if (last.right > frame.right + 1) found.push('out of reach: ' + row.textContent);
    }
    box.scrollLeft = 0;
  }
  scrollTo(1e6, 0);
  if (scrollX > 0) found.push('the page moves by ' + scrollX);
  return found;
})()"""

# From top to bottom: claim, verdict, numbers, reason, of each row.
CLAIMS = """[...document.querySelectorAll('.claims tbody tr')].filter(row => {
  const top = e => e.getBoundingClientRect().top, last = row.cells[4];
  const tops = [row.cells[0], last.querySelector('span'), row.cells[1], row.cells[2], row.cells[3],
                last.querySelector('small')].map(top);
  return tops.some((y, i) => i > 0 && !(y > tops[i - 1]));
}).map(row => row.cells[0].textContent)"""

# Whether the finding comes first, with the numbers of the run below every picture.
BEGINS = """(() => {
  const first = document.querySelector('main > :not(h1):not(.command):not(.verdict)');
  const numbers = [...document.querySelectorAll('.numbers')].pop();
  const pictures = [...document.querySelectorAll('svg.plot,svg.mesh')];
  return first.matches('p.finding') &&
    pictures.every(p => !numbers || p.compareDocumentPosition(numbers) & Node.DOCUMENT_POSITION_FOLLOWING); })()"""

# Colours of each legend that are equal, and colours of faces that no legend has.
COLOURS = """(() => {
  const fill = e => getComputedStyle(e).fill, found = [], known = new Set();
  for (const keys of document.querySelectorAll('.keys')) {
    const fills = [...keys.querySelectorAll('.face')].map(fill);
    if (fills.length < 5 || new Set(fills).size !== fills.length) found.push('legend: ' + fills);
    fills.forEach(f => known.add(f));
  }
  for (const face of document.querySelectorAll('.face')) if (!known.has(fill(face))) found.push(face.outerHTML);
  return found; })()"""

# Contrast of every text with the page, as WCAG 2 computes it: the least, and whose.
CONTRAST = """(() => {
  const light = c => {
    const [r, g, b] = c.match(/[\\d.]+/g).map(v => v / 255)
      .map(v => v <= .03928 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4);
    return .2126 * r + .7152 * g + .0722 * b; };
  const ground = light(getComputedStyle(document.body).backgroundColor);
  let least = [99, ''];
  for (const e of document.querySelectorAll('h1,h2,h3,p,th,td,small,figcaption,code,text,button,output,label')) {
    if (!e.textContent.trim()) continue;
    const style = getComputedStyle(e);
    const own = light(e.tagName === 'text' ? style.fill : style.color);
    const ratio = (Math.max(own, ground) + .05) / (Math.min(own, ground) + .05);
    if (ratio < least[0]) least = [ratio, e.textContent];
  }
  return least;
})()"""

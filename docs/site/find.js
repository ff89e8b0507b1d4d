// SPDX-License-Identifier: GPL-3.0-or-later
// Of find.html: ENTRIES are [address, page, heading, text]. The heading counts ten times as much as the text, and more
// where it is the name that was typed, or has all words in this order.
const words = document.getElementById('find-words');
const found = document.getElementById('find-found');
const count = document.getElementById('find-count');
const LOWERED = ENTRIES.map(entry => [entry[2].toLowerCase(), entry[3].toLowerCase()]);
const MOST = 50;

function score(entry, wanted) {
  let sum = 0;
  for (const word of wanted) {
    const inHeading = entry[0].includes(word), inText = entry[1].split(word).length - 1;
    if (!inHeading && inText === 0) return 0;
    sum += (inHeading ? 10 : 0) + Math.min(inText, 5);
  }
  const asTyped = wanted.length === 1 ? entry[0].split(/::|[.]/).pop() === wanted[0]
                                      : entry[0].includes(wanted.join(' '));
  return sum + (asTyped ? 20 : 0);
}

function excerpt(text, word) {
  const at = Math.max(0, text.toLowerCase().indexOf(word) - 80);
  return (at > 0 ? '… ' : '') + text.slice(at, at + 240) + (at + 240 < text.length ? ' …' : '');
}

function find() {
  const wanted = words.value.toLowerCase().split(/\s+/).filter(word => word);
  found.replaceChildren();
  count.textContent = '';
  if (wanted.length === 0) return;
  const hits = LOWERED.map((entry, number) => [score(entry, wanted), number]).filter(hit => hit[0] > 0);
  hits.sort((a, b) => b[0] - a[0] || a[1] - b[1]);
  count.textContent = hits.length === 0 ? 'Nothing has all of these words.'
    : `${hits.length} found` + (hits.length > MOST ? `, the first ${MOST} of them here` : '');
  for (const [, number] of hits.slice(0, MOST)) {
    const [address, page, heading, text] = ENTRIES[number];
    const [item, link, small] = ['li', 'a', 'small'].map(kind => document.createElement(kind));
    link.href = address;
    link.textContent = heading;
    small.textContent = page === heading ? '' : ` ${page}`;
    item.append(link, small, document.createElement('br'), excerpt(text, wanted[0]));
    found.append(item);
  }
}

words.addEventListener('input', () => {
  history.replaceState(null, '', words.value ? `#${encodeURIComponent(words.value)}` : ' ');
  find();
});
words.value = decodeURIComponent(location.hash.slice(1));
find();

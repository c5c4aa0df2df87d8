'use strict';
(() => {
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const tip = document.getElementById('tip');
  const clamp = (v, low, high) => Math.max(low, Math.min(high, v));

  function placeTip(x, y) {
    tip.hidden = false;
    const w = tip.offsetWidth, h = tip.offsetHeight;
    const top = y + 18 + h > innerHeight ? y - h - 14 : y + 18;
    tip.style.transform = `translate(${clamp(x - w / 2, 6, innerWidth - w - 6)}px, ${Math.max(6, top)}px)`;
  }
  const hideTip = () => { tip.hidden = true; };

  // Marks and table cells: text of their own.
  function showMark(mark, x, y) {
    if (!mark.dataset.tip) return hideTip();
    tip.textContent = mark.dataset.tip;
    placeTip(x, y);
  }
  document.addEventListener('pointermove', (event) => {
    const mark = event.target.closest('[data-tip]');
    if (mark) showMark(mark, event.clientX, event.clientY);
    else if (!event.target.closest('.area')) hideTip();
  });
  document.addEventListener('pointerdown', (event) => {
    const mark = event.target.closest('[data-tip]');
    if (mark) showMark(mark, event.clientX, event.clientY);
    else if (!event.target.closest('.area')) hideTip();
  });
  document.addEventListener('focusin', (event) => {
    if (!event.target.matches('[data-tip]:focus-visible')) return;
    const box = event.target.getBoundingClientRect();
    showMark(event.target, box.x + box.width / 2, box.y + box.height);
  });
  document.addEventListener('focusout', hideTip);
  document.addEventListener('keydown', (event) => { if (event.key === 'Escape') hideTip(); });
  addEventListener('scroll', hideTip, {passive: true});

  // Line plots: all lines at the nearest place. Legends: the rest of the plot steps back.
  for (const figure of all('figure.lines')) {
    const area = figure.querySelector('.area');
    const data = JSON.parse(figure.querySelector('script').textContent);
    const cursor = document.createElement('div');
    cursor.className = 'cursor';
    cursor.hidden = true;
    area.append(cursor);
    let at = 0;
    function show(index, y) {
      at = clamp(index, 0, data.places.length - 1);
      const box = area.getBoundingClientRect();
      cursor.hidden = false;
      cursor.style.left = 100 * data.places[at] + '%';
      tip.textContent = data.x[at];
      for (const line of data.lines) {
        const row = document.createElement('div'), name = document.createElement('span');
        const value = document.createElement('span'), swatch = document.createElement('i');
        swatch.className = line.series;
        name.append(swatch, line.label);
        value.textContent = line.texts[at];
        row.append(name, value);
        tip.append(row);
      }
      placeTip(box.x + box.width * data.places[at], y);
    }
    function nearest(event) {
      const box = area.getBoundingClientRect(), x = (event.clientX - box.x) / box.width;
      let best = 0;
      data.places.forEach((place, k) => { if (Math.abs(place - x) < Math.abs(data.places[best] - x)) best = k; });
      show(best, event.clientY);
    }
    area.addEventListener('pointermove', nearest);
    area.addEventListener('pointerdown', nearest);
    area.addEventListener('pointerleave', () => { cursor.hidden = true; hideTip(); });
    area.addEventListener('blur', () => { cursor.hidden = true; });
    area.addEventListener('keydown', (event) => {
      const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (!step) return;
      event.preventDefault();
      show(at + step, area.getBoundingClientRect().y + 200);
    });
  }
  for (const item of all('.lines .legend li')) {
    const figure = item.closest('figure');
    const step = (on) => all('[data-series]', figure).forEach(
        (mark) => mark.classList.toggle('dim', on && mark.dataset.series !== item.dataset.series));
    item.addEventListener('pointerenter', () => step(true));
    item.addEventListener('pointerleave', () => step(false));
  }

  // Tabs: one panel of each list at a time.
  for (const list of all('.tabs')) {
    const tabs = all('button', list);
    const choose = (tab) => {
      for (const other of tabs) {
        other.setAttribute('aria-selected', other === tab);
        document.getElementById(other.getAttribute('aria-controls')).hidden = other !== tab;
      }
    };
    tabs.forEach((tab, k) => {
      tab.addEventListener('click', () => choose(tab));
      tab.addEventListener('keydown', (event) => {
        const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
        if (!step) return;
        const next = tabs[(k + step + tabs.length) % tabs.length];
        choose(next);
        next.focus();
      });
    });
    if (tabs.length) choose(tabs[0]);
  }

  // Reading pixels: from the colour back to the bin of counts.
  const grouped = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, ',');
  for (const panel of all('.maps')) {
    const scale = JSON.parse(panel.querySelector('script').textContent);
    const binOf = new Map(scale.colours.map((colour, k) => [parseInt(colour.slice(1), 16), k]));
    function textOf(bin) {
      const first = scale.first[bin];
      const last = bin + 1 < scale.first.length ? scale.first[bin + 1] - 1 : scale.maximum;
      return first === last ? grouped(first) : `${grouped(first)} to ${grouped(last)}`;
    }
    const figures = all('.map', panel);
    function pixelsOf(figure) {
      const image = figure.querySelector('img');
      if (!figure.pixels && image.complete && image.naturalWidth) {
        const canvas = document.createElement('canvas');
        canvas.width = image.naturalWidth;
        canvas.height = image.naturalHeight;
        const context = canvas.getContext('2d', {willReadFrequently: true});
        context.drawImage(image, 0, 0);
        figure.pixels = context.getImageData(0, 0, canvas.width, canvas.height);
      }
      return figure.pixels;
    }
    function read(scene, x, y) {
      for (const figure of figures.filter((other) => other.dataset.scene === scene)) {
        const pixels = pixelsOf(figure);
        if (!pixels || x >= pixels.width || y >= pixels.height) continue;
        const i = 4 * (y * pixels.width + x), d = pixels.data;
        const bin = binOf.get(d[i] << 16 | d[i + 1] << 8 | d[i + 2]);
        const n = +figure.dataset.reduction;
        figure.classList.add('read');
        figure.querySelector('output').textContent = `(${x * n}, ${y * n}): ${bin === undefined ? '?' : textOf(bin)}`;
        const box = figure.querySelector('.canvas');
        const ring = box.querySelector('b') || box.appendChild(document.createElement('b'));
        ring.style.left = 100 * (x + 0.5) / pixels.width + '%';
        ring.style.top = 100 * (y + 0.5) / pixels.height + '%';
      }
    }
    for (const figure of figures) {
      const box = figure.querySelector('.canvas');
      let at = null;
      function point(event) {
        const area = box.getBoundingClientRect(), pixels = pixelsOf(figure);
        if (!pixels) return;
        at = [clamp(Math.floor((event.clientX - area.x) / area.width * pixels.width), 0, pixels.width - 1),
              clamp(Math.floor((event.clientY - area.y) / area.height * pixels.height), 0, pixels.height - 1)];
        read(figure.dataset.scene, ...at);
      }
      box.addEventListener('pointermove', point);
      box.addEventListener('pointerdown', point);
      box.addEventListener('keydown', (event) => {
        const move = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
        const pixels = pixelsOf(figure);
        if (!move || !pixels) return;
        event.preventDefault();
        const [x, y] = at || [pixels.width >> 1, pixels.height >> 1], step = event.shiftKey ? 16 : 1;
        at = [clamp(x + step * move[0], 0, pixels.width - 1), clamp(y + step * move[1], 0, pixels.height - 1)];
        read(figure.dataset.scene, ...at);
      });
    }
  }
})();

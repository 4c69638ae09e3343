// What a mouse, a finger or two, a wheel and the page's address mean.

/// Rates that play a run in about ten seconds, ten times slower and faster ones around it, and real time.
function speedChoices(duration) {
  if (!(duration > 0)) return [{rate: 1, label: 'real time', usual: true}];
  const spread = [1, 2, 5], places = [];
  for (let power = -12; power < 6; ++power) for (const digit of spread) places.push(digit * 10 ** power);
  const usual = places.findIndex(rate => rate >= duration / 10 * 0.999);
  const label = rate => {
    const factor = Number((rate >= 1 ? rate : 1 / rate).toPrecision(3)).toLocaleString('en');
    return rate === 1 ? 'real time' : rate > 1 ? `${factor} times real time` : `1/${factor} of real time`;
  };
  return places.slice(usual - 3, usual + 4).map((rate, k) => ({rate, label: label(rate), usual: k === 3}));
}

function followPointers(stage, {turn, shift, magnify}) {
  const held = new Map();
  const spread = () => {
    const [a, b] = [...held.values()];
    return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y)};
  };
  stage.addEventListener('pointerdown', event => {
    stage.setPointerCapture(event.pointerId);
    held.set(event.pointerId, {x: event.clientX, y: event.clientY});
  });
  for (const end of ['pointerup', 'pointercancel']) stage.addEventListener(end, e => held.delete(e.pointerId));
  stage.addEventListener('pointermove', event => {
    if (!held.has(event.pointerId)) return;
    const was = held.get(event.pointerId), two = held.size === 2 ? spread() : null;
    held.set(event.pointerId, {x: event.clientX, y: event.clientY});
    const height = stage.clientHeight, dx = event.clientX - was.x, dy = event.clientY - was.y;
    if (two) {
      const now = spread();
      shift((now.x - two.x) / height, -(now.y - two.y) / height);
      if (two.apart > 0 && now.apart > 0) magnify(now.apart / two.apart);
    } else if (event.shiftKey || event.buttons & 6) {
      shift(dx / height, -dy / height);
    } else {
      turn(-180 * dx / height, 180 * dy / height);
    }
  });
  stage.addEventListener('contextmenu', event => event.preventDefault());
  // A wheel over a picture that nobody chose scrolls the page.
  stage.addEventListener('wheel', event => {
    if (document.activeElement !== stage && !event.ctrlKey) return;
    event.preventDefault();
    magnify(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)));
  }, {passive: false});
}

/// "#time=0.2&colour=size&azimuth=30&elevation=10&zoom=1.5&contacts=1&walls=0": where the page begins.
function readAddress(camera, set) {
  for (const [name, text] of new URLSearchParams(location.hash.slice(1))) {
    const value = Number(text);
    if (name === 'colour') set.colour(text);
    else if (text === '' || !Number.isFinite(value)) continue;
    else if (name === 'azimuth') camera.azimuth = value;
    else if (name === 'elevation') camera.elevation = clamp(value, -90, 90);
    else if (name === 'zoom') camera.zoom = 1, camera.magnify(value);
    else if (['time', 'contacts', 'walls'].includes(name)) set[name](value);
  }
}

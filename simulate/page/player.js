// The page's controls around the picture: time, speed, colours, and where it is seen from, by mouse, touch, keys and
// buttons alike. Nothing moves before it is asked to.

function startPlayer() {
  const motion = readMotion(), {facts} = motion, {times} = facts, last = motion.frames - 1;
  const camera = makeCamera(facts.up, motion.corners), picture = makePicture(motion);
  const colourings = makeColourings(motion);
  const at = id => document.getElementById(id);
  let stage = at('stage'), renderer = makeWebgl(stage, motion.most > 2000);
  const state = {moment: 0, playing: false, colour: 'speed', contacts: false, walls: true, rate: 1};
  let due = false, lastTick = 0;

  // --- time
  const timeAt = moment => {
    const k = Math.min(Math.floor(moment), last);
    return times[k] + (moment - k) * ((times[k + 1] ?? times[k]) - times[k]);
  };
  const momentAt = time => {
    let k = 0, above = last;
    while (above - k > 1) {
      const middle = (k + above) >> 1;
      if (times[middle] <= time) k = middle;
      else above = middle;
    }
    return clamp(k + (time - times[k]) / (times[above] - times[k] || 1), 0, last);
  };
  const spelled = time => quantity(time, 's', times[last]);
  const tell = () => { at('told').textContent = sentence(); };
  const sentence = () => {
    const frame = Math.round(state.moment), count = facts.pairs[frame] + facts.touches[frame];
    return `${spelled(timeAt(state.moment))}: ${motion.count(frame)} spheres, the fastest at ` +
      `${quantity(facts.fastest[frame], 'm/s')}, ${count} contacts`;
  };

  // --- drawing
  const channel = text => text.match(/\d+/g).slice(0, 3).map(Number);
  const inks = () => {
    const style = getComputedStyle(stage), line = getComputedStyle(at('time-text'));
    picture.ground = channel(style.backgroundColor);
    picture.ink = channel(style.color);
    picture.wallInk = channel(line.color);
  };
  const fit = () => {
    const density = Math.min(devicePixelRatio || 1, 2);
    const [width, height] = [stage.clientWidth, stage.clientHeight].map(x => Math.max(1, Math.round(x * density)));
    if (stage.width !== width || stage.height !== height) stage.width = width, stage.height = height;
  };
  const draw = () => {
    fit();
    inks();
    picture.set(state.moment, timeAt(state.moment), colourings[state.colour], state);
    const seen = camera.seen(stage.width / stage.height);
    renderer.draw(seen, picture);
    at('time').value = state.moment;
    at('time').setAttribute('aria-valuetext', spelled(timeAt(state.moment)));
    at('time-text').textContent = spelled(timeAt(state.moment));
    at('now').textContent = sentence();
    return seen;
  };
  const tick = now => {
    due = false;
    if (state.playing) {
      const time = timeAt(state.moment) + state.rate * Math.min(now - lastTick, 250) / 1000;
      state.moment = momentAt(time);
      if (time >= times[last]) play(false);
      else refresh();
    }
    lastTick = now;
    draw();
  };
  const refresh = () => {
    if (due) return;
    due = true;
    requestAnimationFrame(tick);
  };
  const play = on => {
    if (on && state.moment >= last) state.moment = 0;
    if (on && !state.playing) lastTick = performance.now();
    state.playing = on && last > 0;
    at('play').textContent = state.playing ? 'Pause' : 'Play';
    if (!on) tell();
    refresh();
  };
  const seek = moment => {
    state.moment = clamp(moment, 0, last);
    tell();
    refresh();
  };
  const step = by => {
    play(false);
    seek(by > 0 ? Math.floor(state.moment + 1e-9) + 1 : Math.ceil(state.moment - 1e-9) - 1);
  };

  // --- controls
  const colourBy = name => {
    state.colour = name;
    at('colour').value = name;
    showLegend(at('legend'), colourings[name]);
    refresh();
  };
  const seenFrom = change => { change(), refresh(); };
  const turn = (azimuth, elevation) => seenFrom(() => camera.turn(azimuth, elevation));
  const magnify = factor => seenFrom(() => camera.magnify(factor));
  const shift = (x, y) => seenFrom(() => camera.shift(x, y));
  const check = (name, on) => {
    state[name] = at(name).checked = on;
    refresh();
  };
  const rates = speedChoices(times[last] - times[0]);
  const choose = k => {
    at('rate').selectedIndex = clamp(k, 0, rates.length - 1);
    state.rate = rates[at('rate').selectedIndex].rate;
  };
  const actions = {
    play: () => play(!state.playing), back: () => step(-1), forth: () => step(1),
    first: () => seek(0), last: () => seek(last),
    slower: () => choose(at('rate').selectedIndex - 1), faster: () => choose(at('rate').selectedIndex + 1),
    left: () => turn(-10, 0), right: () => turn(10, 0), up: () => turn(0, 10), down: () => turn(0, -10),
    shiftLeft: () => shift(-0.05, 0), shiftRight: () => shift(0.05, 0), shiftUp: () => shift(0, 0.05),
    shiftDown: () => shift(0, -0.05), nearer: () => magnify(1.2), farther: () => magnify(1 / 1.2),
    reset: () => seenFrom(camera.reset), contacts: () => check('contacts', !state.contacts),
    walls: () => check('walls', !state.walls), speed: () => colourBy('speed'), spin: () => colourBy('spin'),
    size: () => colourBy('size'), material: () => colourBy('material'),
  };
  const keys = {
    ' ': 'play', ',': 'back', '.': 'forth', Home: 'first', End: 'last', '[': 'slower', ']': 'faster',
    ArrowLeft: 'left', ArrowRight: 'right', ArrowUp: 'up', ArrowDown: 'down', '+': 'nearer', '=': 'nearer',
    '-': 'farther', 0: 'reset', c: 'contacts', w: 'walls', 1: 'speed', 2: 'spin', 3: 'size', 4: 'material',
  };
  const shifted = {ArrowLeft: 'shiftLeft', ArrowRight: 'shiftRight', ArrowUp: 'shiftUp', ArrowDown: 'shiftDown'};

  rates.forEach(({label}) => at('rate').add(new Option(label)));
  choose(rates.findIndex(({usual}) => usual));
  at('rate').addEventListener('change', () => choose(at('rate').selectedIndex));
  at('time').max = last;
  at('time').addEventListener('input', () => { play(false), seek(Number(at('time').value)); });
  at('colour').addEventListener('change', () => colourBy(at('colour').value));
  for (const name of ['contacts', 'walls']) at(name).addEventListener('change', () => check(name, at(name).checked));
  for (const button of document.querySelectorAll('button[data-does]'))
    button.addEventListener('click', () => actions[button.dataset.does]());

  const listen = () => {
    stage.addEventListener('keydown', event => {
      const does = (event.shiftKey && shifted[event.key]) || keys[event.key] || keys[event.key.toLowerCase()];
      if (!does || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      actions[does]();
    });
    followPointers(stage, {turn, shift, magnify});
    stage.addEventListener('webglcontextlost', useCanvas);
  };
  const useCanvas = () => {
    const fresh = stage.cloneNode(false);
    stage.replaceWith(fresh);
    stage = fresh;
    renderer = makeCanvas(stage);
    at('drawn').textContent = renderer.name;
    listen();
    refresh();
  };

  readAddress(camera, {
    colour: name => { if (Object.hasOwn(colourings, name)) state.colour = name; },
    time: value => { state.moment = momentAt(value); },
    contacts: value => check('contacts', value !== 0), walls: value => check('walls', value !== 0),
  });
  colourBy(state.colour);
  if (renderer) at('drawn').textContent = renderer.name, listen();
  else useCanvas();
  at('player').hidden = false;
  new ResizeObserver(refresh).observe(stage);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', refresh);
  tell();
  draw();
  window.ricochetView = {draw, camera, motion, state, colourings}; // for those who script the page, tests among them
}

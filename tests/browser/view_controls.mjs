// Keys, buttons, slider and mouse of the page of `simulate --view`.

/// `hold(good, what, detail)` takes what was found.
export async function check_controls(page, hold, kind, frames) {
  const state = () => page.evaluate(() => {
    const {state: s, camera: c} = window.ricochetView, at = id => document.getElementById(id);
    return {moment: s.moment, playing: s.playing, colour: s.colour, contacts: s.contacts, walls: s.walls, rate: s.rate,
      azimuth: c.azimuth, elevation: c.elevation, zoom: c.zoom, target: c.target.join(), told: at('told').textContent,
      play: at('play').textContent, legend: at('legend').textContent, slider: Number(at('time').value),
      spoken: at('time').getAttribute('aria-valuetext'), checked: at('contacts').checked};
  });
  const wait = () => page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
  /// Does it, and holds that `changed(before, after)` is true.
  const does = async (what, act, changed) => {
    const before = await state();
    await act();
    await wait();
    const after = await state();
    hold(changed(before, after), `${kind}, ${what}`, `${JSON.stringify(before)} became ${JSON.stringify(after)}`);
  };
  const key = (name, changed) => does(`key ${name}`, () => page.keyboard.press(name), changed);
  const last = frames.length - 1, near = (a, b) => Math.abs(a - b) < 1e-9;

  await page.focus('#stage');
  await key('Home', (a, b) => b.moment === 0 && b.slider === 0);
  await key('.', (a, b) => b.moment === 1 && b.told !== a.told);
  await key(',', (a, b) => b.moment === 0);
  await key(',', (a, b) => b.moment === 0);
  await key('End', (a, b) => b.moment === last && b.told.includes(`${frames[last].spheres.length} spheres`));
  await key('0', (a, b) => b.azimuth === -60 && b.zoom === 1 && b.target === '0,0,0');
  await key('ArrowRight', (a, b) => near(b.azimuth - a.azimuth, 10));
  await key('ArrowLeft', (a, b) => near(b.azimuth - a.azimuth, -10));
  await key('ArrowUp', (a, b) => near(b.elevation - a.elevation, 10));
  await key('ArrowDown', (a, b) => near(b.elevation - a.elevation, -10));
  await key('Shift+ArrowUp', (a, b) => a.target !== b.target && a.elevation === b.elevation);
  await key('+', (a, b) => near(b.zoom / a.zoom, 1.2));
  await key('-', (a, b) => near(a.zoom / b.zoom, 1.2));
  await key(']', (a, b) => b.rate > a.rate);
  await key('[', (a, b) => b.rate < a.rate);
  for (const [name, colour] of [['2', 'spin'], ['3', 'size'], ['4', 'material'], ['1', 'speed']])
    await key(name, (a, b) => b.colour === colour && a.legend !== b.legend);
  const units = {speed: 'm/s', spin: '1/s', size: 'm', material: 'Material'};
  for (const [colour, unit] of Object.entries(units))
    await does(`colour by ${colour}`, () => page.selectOption('#colour', colour),
      (a, b) => b.colour === colour && b.legend.includes(unit));
  await page.focus('#stage');
  await key('c', (a, b) => a.contacts !== b.contacts && b.checked === b.contacts);
  await key('w', (a, b) => a.walls !== b.walls);

  await key('Home', (a, b) => b.moment === 0);
  await does('playing', async () => { await page.keyboard.press(' '); await page.waitForTimeout(400); },
    (a, b) => b.playing && b.moment > 0 && b.play === 'Pause');
  await key(' ', (a, b) => !b.playing && b.play === 'Play' && a.told !== b.told);
  const rested = await state();
  await page.waitForTimeout(150);
  hold((await state()).moment === rested.moment, `${kind}, pause`, 'time goes on');
  await key('End', (a, b) => b.moment === last);
  await does('playing from the end', () => page.click('#play'), (a, b) => b.playing && b.moment < last);
  await does('the button', () => page.click('#play'), (a, b) => !b.playing);

  await page.focus('#time');
  await key('Home', (a, b) => b.moment === 0 && b.slider === 0);
  await key('PageUp', (a, b) => b.moment > a.moment && b.spoken !== a.spoken && near(b.slider, b.moment));
  for (const name of ['Frame before', 'Next frame', 'Turn left', 'Turn right', 'Look from higher', 'Look from lower',
    'Nearer', 'Farther', 'Reset'])
    await does(`button ${name}`, () => page.getByRole('button', {name, exact: true}).click(),
      (a, b) => JSON.stringify(a) !== JSON.stringify(b) || name === 'Reset');

  const {x, y, width, height} = await page.locator('#stage').boundingBox();
  const drag = async (dx, dy) => {
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + dx, y + height / 2 + dy, {steps: 4});
    await page.mouse.up();
  };
  await does('a wheel over a picture not chosen', async () => {
    await page.mouse.move(x + 9, y + 9);
    await page.mouse.wheel(0, 80);
  }, (a, b) => a.zoom === b.zoom);
  await page.evaluate(() => scrollTo(0, 0));
  await does('a drag', () => drag(60, 20), (a, b) => b.azimuth < a.azimuth && b.elevation > a.elevation);
  await does('a drag with Shift', async () => {
    await page.keyboard.down('Shift');
    await drag(30, 0);
    await page.keyboard.up('Shift');
  }, (a, b) => a.target !== b.target && a.azimuth === b.azimuth);
  await does('the wheel', () => page.mouse.wheel(0, -120), (a, b) => b.zoom > a.zoom);
}

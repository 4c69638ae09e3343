// What is to be drawn at a moment: the spheres of the nearest frame, and where they are on their way between the two
// around it. Arrays are filled anew only when another frame, or another meaning of the colours, is wanted.

/// Where the lines of all walls are at a time: they travel, swing and spin as the walls do.
function makeWalls(motion) {
  const walls = motion.facts.walls.filter(wall => wall.lines.length), turns = 2 * Math.PI;
  const strokes = walls.map(({lines}) => lines.flatMap(line => line.slice(1).flatMap((p, k) => [line[k], p])));
  const moves = walls.some(w => w.spin || w.frequency || w.velocity.some(Boolean));
  const out = new Float32Array(3 * strokes.reduce((all, points) => all + points.length, 0));
  let filled = false;
  return time => {
    if (filled && !moves) return out;
    let k = 0;
    walls.forEach((wall, n) => {
      const swing = Math.sin(turns * wall.frequency * time);
      const [c, s] = [Math.cos, Math.sin].map(f => f(wall.spin * time));
      const shift = sum([time, wall.velocity], [swing, wall.amplitude]);
      for (const p of strokes[n]) {
        const from = sum([1, p], [-1, wall.point]), along = dot(from, wall.axis);
        const turned = wall.spin
          ? sum([c, from], [(1 - c) * along, wall.axis], [s, cross(wall.axis, from)], [1, wall.point]) : p;
        out.set(motion.scaled(sum([1, turned], [1, shift])), k);
        k += 3;
      }
    });
    filled = true;
    return out;
  };
}

function makePicture(motion) {
  const {most, radii} = motion, floats = length => new Float32Array(length);
  const [before, after, here, there] = [0, 1, 2, 3].map(() => floats(3 * most));
  const [toneBefore, toneAfter, radius] = [0, 1, 2].map(() => floats(most));
  const period = motion.period, periods = period.filter(p => p > 0);
  const picture = {
    before, after, toneBefore, toneAfter, radius, between: 0, swell: 1, count: 0, contacts: floats(0),
    contactLength: 0, fresh: true,
    jump: Math.min(0.5, ...periods.map(p => p / 2)), // who goes farther was put elsewhere
  };
  const wallsAt = makeWalls(motion), noWalls = floats(0), placeThere = new Int32Array(radii.length);
  let filledFor = [];

  // The spheres of the frame `shown`; where the other frame lacks one, it stays.
  const fill = (frame, next, shown, colouring) => {
    const other = shown === frame ? next : frame, present = motion.present(shown);
    motion.places(shown, here);
    motion.places(other, there);
    placeThere.fill(-1);
    motion.present(other).forEach((sphere, k) => { placeThere[sphere] = k; });
    const [own, others] = shown === frame ? [before, after] : [after, before];
    const [ownTone, otherTone] = shown === frame ? [toneBefore, toneAfter] : [toneAfter, toneBefore];
    for (let k = 0; k < present.length; ++k) {
      const at = placeThere[present[k]];
      for (let a = 0; a < 3; ++a) {
        own[3 * k + a] = here[3 * k + a];
        others[3 * k + a] = at < 0 ? here[3 * k + a] : there[3 * at + a];
      }
      ownTone[k] = colouring.tone(shown, k);
      otherTone[k] = at < 0 ? ownTone[k] : colouring.tone(other, at);
      radius[k] = radii[present[k]];
    }
    picture.count = present.length;
  };
  const centre = k => {
    const way = [0, 1, 2].map(a => after[3 * k + a] - before[3 * k + a]);
    const share = Math.hypot(...way) > picture.jump ? Math.round(picture.between) : picture.between;
    return way.map((x, a) => before[3 * k + a] + share * x);
  };
  const fillContacts = frame => {
    const pairs = motion.pairs(frame), touching = motion.touching(frame), towards = motion.towards(frame);
    const length = 3 * pairs.length + 6 * touching.length;
    if (picture.contacts.length < length) picture.contacts = floats(2 * length);
    let at = 0;
    const line = (from, way) => {
      picture.contacts.set(from, at);
      picture.contacts.set(from.map((x, a) => x + way[a]), at + 3);
      at += 6;
    };
    for (let k = 0; k < pairs.length; k += 2) {
      const from = centre(pairs[k]), to = centre(pairs[k + 1]);
      // The shortest way, across the border where space repeats.
      line(from, to.map((x, a) => x - from[a] - (period[a] ? period[a] * Math.round((x - from[a]) / period[a]) : 0)));
    }
    touching.forEach((i, n) => line(centre(i), [0, 1, 2].map(a => radius[i] * towards[3 * n + a] / 127)));
    picture.contactLength = length;
  };

  /// `moment` counts frames, with a fraction: places in between are on the straight line.
  picture.set = (moment, time, colouring, {contacts, walls}) => {
    const frame = Math.min(Math.floor(moment), motion.frames - 1), next = Math.min(frame + 1, motion.frames - 1);
    picture.between = moment - frame;
    const shown = picture.between < 0.5 ? frame : next, wanted = [frame, shown, colouring];
    picture.fresh = wanted.some((x, k) => x !== filledFor[k]);
    if (picture.fresh) fill(frame, next, shown, colouring);
    filledFor = wanted;
    picture.table = colouring.table, picture.byName = Boolean(colouring.names);
    picture.swell = contacts ? 0.35 : 1;
    picture.walls = walls ? wallsAt(time) : noWalls;
    picture.contactLength = 0;
    if (contacts) fillContacts(shown);
  };
  return picture;
}

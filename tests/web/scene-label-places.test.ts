import { LabelPlaces, type Place, type Trace } from '../../dist/scene/label-places.js';

const NUMBER = 20;
const at = (x: number, y: number): Place => ({ x, y });

/** The nearest of the traces to a place, by their points a pixel apart. */
function nearest(place: Place, traces: readonly Trace[]): Trace {
  const distances = traces.map((trace) => {
    const [a, b] = [trace[0], trace[trace.length - 1]];
    const steps = Math.max(1, Math.ceil(Math.hypot(b.x - a.x, b.y - a.y)));
    let least = Infinity;
    for (let i = 0; i <= steps; i++) {
      const [x, y] = [a.x + (i / steps) * (b.x - a.x), a.y + (i / steps) * (b.y - a.y)];
      least = Math.min(least, Math.hypot(place.x - x, place.y - y));
    }
    return least;
  });
  return traces[distances.indexOf(Math.min(...distances))];
}

describe('Labels that go aside', () => {
  test('stay where they would be while nothing is in their way', () => {
    const line = [at(0, 0), at(100, 0)];
    const places = new LabelPlaces([line, [at(50, 80), at(90, 80)]]);
    expect(places.best(at(50, -22), NUMBER, line)).toEqual(at(50, -22));
  });

  test('go along their line, away from where another one crosses it', () => {
    const line = [at(0, 0), at(100, 0)];
    const place = new LabelPlaces([line, [at(50, -40), at(50, 40)]]).best(at(50, 0), NUMBER, line);
    expect(place?.y).toBe(0);
    expect(Math.abs((place as Place).x - 50)).toBeGreaterThan(NUMBER / 2);
    expect(nearest(place as Place, [line, [at(50, -40), at(50, 40)]])).toBe(line);
  });

  test('leave room for names that come later, where something else is free', () => {
    const line = [at(0, 0), at(100, 0)];
    const name = { x: 52, y: -20, width: NUMBER };
    const place = new LabelPlaces([line], [name]).best(at(50, -22), NUMBER, line) as Place;
    expect(Math.abs(place.x - name.x) >= NUMBER || Math.abs(place.y - name.y) >= 17).toBe(true);
    expect(new LabelPlaces([line]).best(at(50, -22), NUMBER, line)).toEqual(at(50, -22));
  });

  test('cover no other label', () => {
    const point = [at(0, 0)];
    const places = new LabelPlaces([point]);
    const taken: Place[] = [];
    for (let i = 0; i < 25; i++) {
      const place = places.best(at(0, 0), NUMBER, point) as Place;
      for (const { x, y } of taken) {
        const covers = Math.abs(x - place.x) < NUMBER && Math.abs(y - place.y) < 17;
        expect(covers).toBe(false);
      }
      places.take(place.x, place.y, NUMBER);
      taken.push(place);
    }
    expect(places.best(at(0, 0), NUMBER, point)).toBeUndefined();
  });

  // As an open grid lies on the screen: a face 90 pixels wide, its name in the middle.
  test('in a small face, are nearest to what they name', () => {
    const self = [at(330, 478), at(362, 414)];
    const next = [at(357, 411), at(274, 409)];
    const prev = [at(236, 462), at(328, 477)];
    const opposite = [at(374, 414), at(344, 476)];
    const vertex = [at(370, 408)];
    const face = [at(300, 440)];
    const traces = [self, vertex, next, opposite, prev, face];
    const places = new LabelPlaces(traces);
    const wanted: [Trace, Place, number][] = [
      [self, at(326, 441), 40],
      [face, at(300, 440), NUMBER],
      [vertex, at(370, 390), NUMBER],
      [next, at(315, 410), NUMBER],
      [opposite, at(359, 445), NUMBER],
      [prev, at(282, 469), NUMBER],
    ];
    for (const [own, where, width] of wanted) {
      const place = places.best(where, width, own) as Place;
      expect(
        nearest(
          place,
          traces.filter((trace) => trace !== face || own === face),
        ),
      ).toBe(own);
      places.take(place.x, place.y, width);
    }
  });
});

import { readFileSync } from 'node:fs';
import { REVISION } from 'three';

/** The package of this suite, as jest.config.mjs names it: 'three' or 'three-oldest'. */
declare const THREE: string;

const { devDependencies, peerDependencies } = JSON.parse(readFileSync('package.json', 'utf8'));
const newest: string = devDependencies.three;
const oldest: string = devDependencies['three-oldest'].replace('npm:three@', '');

test('The suite runs with the three.js that it is for', () => {
  expect(`0.${REVISION}.0`).toBe({ three: newest, 'three-oldest': oldest }[THREE]);
});

test('The oldest three.js that users may have is the oldest that is tested', () => {
  expect(peerDependencies.three).toBe(`>=${oldest}`);
});

import { useThree } from '@react-three/fiber';
import { useEffect, useLayoutEffect } from 'react';
import { MathUtils } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** How far up and down the camera sees, at a distance of 1; in a narrow window, how far left and right. */
const HALF_VIEW = 0.3;

/** Turns the camera around the origin; a frame is drawn whenever it has moved. */
export function Controls() {
  const camera = useThree((state) => state.camera);
  const { domElement } = useThree((state) => state.gl);
  const { aspect } = useThree((state) => state.viewport);
  const invalidate = useThree((state) => state.invalidate);
  useLayoutEffect(() => {
    camera.fov = 2 * MathUtils.radToDeg(Math.atan(HALF_VIEW / Math.min(1, aspect)));
    camera.updateProjectionMatrix();
    invalidate();
  }, [camera, aspect, invalidate]);
  useEffect(() => {
    const controls = new OrbitControls(camera, domElement);
    controls.addEventListener('change', () => invalidate());
    return () => controls.dispose();
  }, [camera, domElement, invalidate]);
  return null;
}

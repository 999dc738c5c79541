/** Drawings for buttons, as paths of an SVG of 24 × 24. */
export const ICONS = {
  play: 'M7 4.5v15l12-7.5z',
  pause: 'M8 5v14M16 5v14',
  forward: 'M6 5v14l9-7zM18.5 5v14',
  back: 'M18 5v14l-9-7zM5.5 5v14',
  restart: 'M4 5v5h5M4.6 10A8 8 0 1 1 4 14',
  open: 'M3.5 18.5v-13h6l2 2.5h9v10.5z',
  sun: 'M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8M12 2.5v2M12 19.5v2M2.5 12h2M19.5 12h2M5.3 5.3l1.4 1.4M17.3 17.3l1.4 1.4M5.3 18.7l1.4-1.4M17.3 6.7l1.4-1.4',
  moon: 'M20 14.5A8.5 8.5 0 0 1 9.5 4a8.5 8.5 0 1 0 10.5 10.5z',
  help: 'M9.2 9a2.9 2.9 0 1 1 4.2 2.6c-.9.5-1.4 1.1-1.4 2.2M12 17.4v.1',
  close: 'M6 6l12 12M18 6L6 18',
  chevron: 'M6 9.5l6 6 6-6',
  focus: 'M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5M12 12v.1',
  ccw: 'M5.5 17.5a8 8 0 1 0-1.4-5.5M3.5 7.5L4 12.3l4.6-1.2',
  cw: 'M18.5 17.5a8 8 0 1 1 1.4-5.5M20.5 7.5L20 12.3l-4.6-1.2',
  arrow: 'M5 12h14M13 6l6 6-6 6',
  warning: 'M12 4.5l8.5 15h-17zM12 10v4.5M12 17v.1',
  check: 'M5 12.5l4.5 4.5L19 7.5',
  undo: 'M8.5 5L4 9.5 8.5 14M4.5 9.5H14a5 5 0 0 1 0 10h-3',
  redo: 'M15.5 5L20 9.5 15.5 14M19.5 9.5H10a5 5 0 0 0 0 10h3',
  refused: 'M12 3.5a8.5 8.5 0 1 0 0 17 8.5 8.5 0 0 0 0-17M6.2 6.2l11.6 11.6',
  download: 'M12 4v11M7 10.5l5 5 5-5M4.5 19.5h15',
  link: 'M10 13.5a4 4 0 0 0 5.7.4l3-3a4 4 0 0 0-5.7-5.7l-1.3 1.3M14 10.5a4 4 0 0 0-5.7-.4l-3 3a4 4 0 0 0 5.7 5.7l1.3-1.3',
  tag: 'M4 12.5V4.5h8L20 12.5 12.5 20zM8 8.5v.1',
  target: 'M12 6a6 6 0 1 0 0 12 6 6 0 0 0 0-12M12 3v5M12 16v5M3 12h5M16 12h5',
} as const;

/** The name of an icon. */
export type IconName = keyof typeof ICONS;

/** Those that are filled rather than drawn with a pen. */
export const FILLED_ICONS: ReadonlySet<IconName> = new Set(['play', 'forward', 'back']);

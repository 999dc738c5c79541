/** What A4 and Letter have room for within their margins, in CSS pixels. */
const [LONG, SHORT] = [960, 690];

/** Has what is printed keep the shape of the window, which the picture was drawn for, as large as the paper lets it. */
export function keepShapeOnPaper(): void {
  const { style, classList } = document.documentElement;
  window.addEventListener('beforeprint', () => {
    const isWide = innerWidth > innerHeight;
    const [width, height] = isWide ? [LONG, SHORT] : [SHORT, LONG];
    const zoom = Math.min(1, width / innerWidth, height / innerHeight);
    style.setProperty('--window-width', `${innerWidth}px`);
    style.setProperty('--window-height', `${innerHeight}px`);
    style.setProperty('--paper-zoom', String(zoom));
    classList.toggle('wide-window', isWide);
  });
}

/** The style sheet of labels; the colours are custom properties, see `declarations`. */
export const LABEL_STYLES = `
.labels {
  position: absolute;
  inset: 0;
  overflow: hidden;
  pointer-events: none;
}

.tag {
  position: absolute;
  top: 0;
  left: 0;
  min-width: 17px;
  padding: 0 5px;
  border-radius: 99px;
  font: 650 11px / 17px var(--sans);
  font-variant-numeric: tabular-nums;
  text-align: center;
  white-space: nowrap;
  transition: opacity var(--quick);
}

.tag.away {
  visibility: hidden;
}

.tag.behind {
  opacity: 0.32;
}

.tag.self,
.tag.hover {
  padding: 0 7px;
  border: 1.5px solid var(--self);
  background: var(--raised);
  color: var(--text);
  font: 600 12px / 18px var(--mono);
}

.tag.problem {
  padding: 0 8px;
  border: 1.5px solid var(--self);
  background: var(--raised);
  color: var(--text);
  font: 600 12px / 19px var(--sans);
}

.tag.hover {
  border-color: var(--line-strong);
}

.tag.ordinal {
  border: 1.5px solid var(--next-text);
  background: var(--raised);
  color: var(--next-text);
  line-height: 15px;
}

.tag.current {
  min-width: 23px;
  border: 2px solid var(--raised);
  background: var(--next-text);
  color: var(--on-color);
  font-size: 13px;
  line-height: 20px;
  box-shadow: 0 0 0 1.5px var(--next-text);
}

/* The name of an item: letters on a halo that sets them apart from lines. */
.tag.index {
  min-width: 0;
  padding: 0 2px;
  color: var(--text);
  font: 600 11px / 15px var(--mono);
  -webkit-text-stroke: 4px var(--halo);
  paint-order: stroke;
  transition: none;
}

/* The number of a link is a square, as in the inspector; that of a visit is round. */
.tag.link {
  border-radius: 3px;
  background: var(--role, var(--muted));
  color: var(--on-color);
  box-shadow: 0 0 0 1.5px var(--raised);
}

.tag.witness {
  padding: 0 7px;
  border: 1.5px dashed var(--opposite-text);
  background: var(--raised);
  color: var(--opposite-text);
  font: 600 12px / 18px var(--mono);
}

.tag.first {
  padding: 0 7px;
  border: 1.5px solid var(--next-text);
  background: var(--raised);
  color: var(--next-text);
  font: 600 12px / 18px var(--mono);
}

.role-self,
.role-face {
  --role: var(--accent);
}

.role-next,
.role-prev,
.role-halfedge {
  --role: var(--next-text);
}

.role-opposite {
  --role: var(--opposite-text);
}

.role-vertex {
  --role: var(--vertex-text);
}

.role-edge {
  --role: var(--muted);
}
`;

// The picture that the explorer and `halfedge/figure` show of a mesh. three.js and three-mesh-bvh are
// peer dependencies of this entry.

export type { PictureFrame } from './capture.js';
export type { ChangedEdge, FormerVertex, SurfaceChange } from './change.js';
export { DARK, declarations, LIGHT, MORE_CONTRAST } from './colors.js';
export type { Mark } from './highlights.js';
export { FILLED_ICONS, ICONS, type IconName } from './icons.js';
export { LABEL_STYLES } from './label-styles.js';
export type { Label } from './labels.js';
export { type Anchors, type Overlay, overlayOf, type Shows } from './marks.js';
export { type Palette, readPalette } from './palette.js';
export { type Captions, MeshPicture, type PictureSource } from './picture.js';
export { listenToPointer, type PointerListener } from './pointer.js';
export { Discs } from './points.js';
export { prefersReducedMotion } from './reduced-motion.js';
export { OwnScreen, type Screen } from './screen.js';
export { SharedScreen } from './shared-screen.js';
export { ShownTriangles } from './shown-triangles.js';
export { SLIDER_STYLES } from './slider-styles.js';
export { FILE_LAYER, type Insets, MESH_LAYER, Stage } from './stage.js';
export { Surface } from './surface.js';
export { SurfaceLook } from './surface-view.js';
export { type Shown, type Sight, Travel } from './travel.js';
export { triangulateRing } from './triangulate-ring.js';
export type { UpAxis } from './up.js';

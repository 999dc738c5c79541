/**
 * For an attribute that is there or not. `false` counts as absent: frameworks that don't know the property write
 * that word, and nobody who writes it means the contrary.
 */
export const FLAG = {
  type: Boolean,
  reflect: true,
  converter: {
    fromAttribute: (value: string | null) => value !== null && value !== 'false',
    toAttribute: (value: unknown) => (value ? '' : null),
  },
};

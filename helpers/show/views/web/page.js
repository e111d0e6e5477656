// What every view's page has: its elements by their ids, and whether the browser can draw in 3-D.
'use strict';

export const at = (name) => document.getElementById(name);

// A virtual machine without 3-D acceleration, a remote desktop, or a browser whose acceleration is off may have none.
const canvas = document.createElement('canvas');
export const webgl = ['webgl2', 'webgl'].some((kind) => canvas.getContext(kind) !== null);

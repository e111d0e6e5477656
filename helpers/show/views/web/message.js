// One message of helpers/show/views/live_view.py: uint32 length of the JSON, the JSON, the block of numbers.
'use strict';

// Returns the JSON's content, and where in the buffer the numbers begin.
export function read(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  return [JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))), 4 + length];
}

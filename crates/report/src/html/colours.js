// The colours of the page, as the style sheet has them for light and dark, and the patterns made of them.

const COLOURS = 8;
let colours = {};

function readColours(context) {
  const style = getComputedStyle(document.documentElement);
  const read = (name) => style.getPropertyValue("--" + name).trim();
  colours = {};
  for (const name of ["sea", "edge", "half", "next", "vertex", "halo", "ink", "quiet", "bad", "mark", "accent"]) {
    colours[name] = read(name);
  }
  colours.faces = Array.from({ length: COLOURS }, (_, i) => read("face-" + i));
  colours.hatch = pattern(context, 8, (tile) => {
    tile.strokeStyle = colours.ink;
    tile.globalAlpha = 0.55;
    tile.lineWidth = 1.4;
    for (const shift of [-8, 0, 8]) {
      tile.beginPath();
      tile.moveTo(shift, 8);
      tile.lineTo(shift + 8, 0);
      tile.stroke();
    }
  });
  colours.dots = pattern(context, 6, (tile) => {
    tile.fillStyle = colours.mark;
    tile.globalAlpha = 0.6;
    tile.beginPath();
    tile.arc(3, 3, 1, 0, 7);
    tile.fill();
  });
}

function pattern(context, size, draw) {
  const tile = document.createElement("canvas");
  tile.width = tile.height = size;
  draw(tile.getContext("2d"));
  return context.createPattern(tile, "repeat");
}

// The scale: a bar of a round length.

/** The greatest length of the bar, in pixels, and the length of a degree of latitude, in kilometres. */
const LONGEST_BAR = 130;
const DEGREE = 111.2;

/** The greatest of 1, 2, 5, 10, 20, … that is not greater than this. */
function round(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].find((n) => n * power <= most * (1 + 1e-9)) * power;
}

/** The bar's length in units of the map, and its label. Degrees are those of longitude in the middle of what is seen. */
function scaleBar(view, unit) {
  const most = LONGEST_BAR / view.scale;
  const kilometres = DEGREE * Math.cos((view.y * Math.PI) / 180);
  if (unit !== "degrees" || Math.abs(view.y) > 89) return [round(most), format(round(most)) + (unit === "degrees" ? "°" : "")];
  const length = round(most * kilometres);
  return [length / kilometres, length < 1 ? `${format(1000 * length)} m` : `${format(length)} km`];
}

function drawScaleBar(context, view, unit) {
  const [length, label] = scaleBar(view, unit);
  const [x, y, wide] = [12, view.height - 12, length * view.scale];
  context.lineCap = "butt";
  context.lineJoin = "miter";
  for (const [colour, width] of [[colours.halo, 4], [colours.ink, 1.5]]) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.moveTo(x, y - 6);
    context.lineTo(x, y);
    context.lineTo(x + wide, y);
    context.lineTo(x + wide, y - 6);
    context.stroke();
  }
  context.font = "12px system-ui, sans-serif";
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  haloed(context, label, x + 5, y - 5, colours.ink);
}

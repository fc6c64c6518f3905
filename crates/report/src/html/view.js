// The part of the map that is seen, and its scale.

/** Pixels to a unit are limited, so that positions in pixels are exact. */
const CLOSEST = 2 ** 38;

/** Room for names beyond what is shown, in pixels. */
const MARGIN = 60;

class View {
  constructor() {
    [this.x, this.y, this.scale, this.width, this.height] = [0, 0, 1, 1, 1];
    this.bounds = [0, 0, 1, 1];
  }

  px(x) {
    return (x - this.x) * this.scale + this.width / 2;
  }

  py(y) {
    return (this.y - y) * this.scale + this.height / 2;
  }

  /** The place at a pixel. */
  at(px, py) {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }

  /** The box that is seen. */
  box() {
    const [w, h] = [this.width / 2 / this.scale, this.height / 2 / this.scale];
    return [this.x - w, this.y - h, this.x + w, this.y + h];
  }

  /** Shows a box, which takes up so much of the width or the height, with room for names around it. */
  fit(box, part, margin = MARGIN) {
    const [w, h] = [box[2] - box[0], box[3] - box[1]];
    this.x = (box[0] + box[2]) / 2;
    this.y = (box[1] + box[3]) / 2;
    const scale = Math.min((part * (this.width - margin)) / w, (part * (this.height - margin)) / h);
    this.scale = this.clamp(Number.isFinite(scale) ? scale : this.scale);
  }

  clamp(scale) {
    const span = Math.max(this.bounds[2] - this.bounds[0], this.bounds[3] - this.bounds[1]) || 1;
    return Math.min(Math.max(scale, 20 / span), CLOSEST / span);
  }

  /** Zooms; the place at this pixel stays there. */
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.at(px, py);
    this.scale = this.clamp(this.scale * factor);
    this.x = x - (px - this.width / 2) / this.scale;
    this.y = y + (py - this.height / 2) / this.scale;
  }

  move(px, py) {
    this.x += px / this.scale;
    this.y -= py / this.scale;
  }

  copy() {
    return Object.assign(new View(), this);
  }
}

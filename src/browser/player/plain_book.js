// A book without WebGL 2, or while its context is lost: six flat faces, in the canvas of the lines.

const kPlainWall = [0.13, 0.14, 0.165];
const kPlainCloth = [0.48, 0.1, 0.1], kPlainPages = [0.87, 0.81, 0.69], kPlainBody = [0.5, 0.52, 0.55];
const kPlainLight = [0.35, 0.55, 0.76];  // Where it comes from.
/** Of each face its picture, and the corners at the picture's top left, top right and bottom left, as it is seen from outside. */
const kPlainFaces = [["front", 6, 7, 4], ["back", 3, 2, 1], ["spine", 2, 6, 0], ["", 7, 3, 5], ["", 2, 3, 6], ["", 4, 5, 0]];

const cssColour = (parts) => `rgb(${parts.map((part) => Math.round(255 * part)).join(" ")})`;

/** Draws them by `overlay`, before its own wall. `look`: {pictures, cloth: [0 to 1] or null, isBook}. */
function drawPlainBook(overlay, sample, {pictures, cloth, isBook}) {
  const {context, book} = overlay, {x, y, width, height} = book.area;
  const wall = overlay.isLight ? kPlainWall.map((part) => 1 - part) : book.backdrop === "stars" ? [0, 0, 0] : kPlainWall;
  context.fillStyle = cssColour(book.plain ?? wall);
  context.fillRect(x, y, width, height);
  for (const [name, ...three] of kPlainFaces) {
    const corners = [...three, three[0] ^ three[1] ^ three[2]].map((corner) => [...cornerOf(sample, corner)]), places = corners.map((corner) => overlay.place(corner));
    if (places.includes(null)) continue;
    const [a, b, c, d] = places, normal = cross(plus(corners[2], corners[0], -1), plus(corners[1], corners[0], -1));
    if ((b[0] - a[0]) * (c[1] - a[1]) <= (b[1] - a[1]) * (c[0] - a[0])) continue;  // Seen from within.
    context.save();
    overlay.path([a, b, d, c]);
    context.fillStyle = cssColour(!isBook ? kPlainBody : name ? cloth ?? kPlainCloth : kPlainPages);
    context.fill();
    context.clip();
    if (name && isBook && !cloth) drawInto(context, pictures[name], places);
    context.fillStyle = `rgb(0 0 0 / ${0.3 - 0.3 * dot(sized(normal, 1), kPlainLight)})`;
    context.fill();
    context.restore();
  }
}

/** Draws a picture into the parallelogram nearest to four corners: top left, top right, bottom left, bottom right. */
function drawInto(context, picture, [a, b, c, d]) {
  const right = [0, 1].map((i) => (b[i] - a[i] + d[i] - c[i]) / 2), down = [0, 1].map((i) => (c[i] - a[i] + d[i] - b[i]) / 2);
  const [x, y] = [0, 1].map((i) => (a[i] + b[i] + c[i] + d[i]) / 4 - (right[i] + down[i]) / 2);
  context.save();
  context.transform(right[0] / picture.width, right[1] / picture.width, down[0] / picture.height, down[1] / picture.height, x, y);
  context.imageSmoothingQuality = "high";
  context.drawImage(picture, 0, 0);
  context.restore();
}

// Draws books with the program's own mesh and shaders, in WebGL 2.

const kShaderHead = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
#define CLIP_Y_UP
`;
// There is no bias of a texture's level but in the call.
const kSharper = "#define texture(sampler, place) texture(sampler, place, -0.5)\n";
const kClearlyOriented = 0.2;  // As in mesh_geometry.cpp.
const kWall = [25 / 255, 28 / 255, 34 / 255];  // The edge of studio.frag's.
const kLightShare = 0.45;  // Of the dark wall, which is taken from white in the light look.
const kAttributes = [3, 3, 2, 1, 1, 3];  // Floats of each, as in body.vert.
const kSamples = 4;     // Of a pixel near a book.
const kBesideBook = 2;  // In its box. [pixels]

/** Returns 1 if the cage is the right way round at every corner, -1 if inside out, 0 if neither. */
function windingOf(cage) {
  const determinants = [];
  for (let i = 0; i < 8; ++i) {
    const edge = (axis) => {
      const other = i ^ (1 << axis), sign = i & (1 << axis) ? 1 : -1;
      return [0, 1, 2].map((k) => sign * (cage[3 * i + k] - cage[3 * other + k]));
    };
    const [a, b, c] = [edge(0), edge(1), edge(2)];
    determinants.push(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]));
  }
  const largest = Math.max(...determinants.map(Math.abs), Number.MIN_VALUE);
  if (Math.min(...determinants) > kClearlyOriented * largest) return 1;
  return Math.max(...determinants) < -kClearlyOriented * largest ? -1 : 0;
}

/** Returns the part of its area in which a book is drawn; all of it if the camera is in the book. */
function boxOf({area, cage, matrix}) {
  const corners = Array.from({length: 8}, (_, i) => projected(matrix, area, cage.subarray(3 * i, 3 * i + 3)));
  if (corners.includes(null)) return area;
  const [[x, right], [y, bottom]] = ["width", "height"].map((size, axis) => {
    const places = corners.map((corner) => corner[axis]), first = area[axis ? "y" : "x"], within = (place) => Math.min(Math.max(place, first), first + area[size]);
    return [within(Math.floor(Math.min(...places)) - kBesideBook), within(Math.ceil(Math.max(...places)) + kBesideBook)];
  });
  return {x, y, width: right - x, height: bottom - y};
}

/** Returns a cover's picture, whose alpha is the share that isn't gold, as withGold() of book_textures.cpp finds it. */
function withGold(picture) {
  const {width, height} = picture, canvas = Object.assign(document.createElement("canvas"), {width, height});
  const context = canvas.getContext("2d", {willReadFrequently: true}), within = (share) => Math.min(Math.max(share, 0), 1);
  context.drawImage(picture, 0, 0);
  const made = context.getImageData(0, 0, width, height), {data} = made;
  const light = Array.from({length: 256}, (_, i) => ((0.305306 * i / 255 + 0.682171) * i / 255 + 0.012523) * i / 255);
  for (let i = 0; i < data.length; i += 4) {
    const red = light[data[i]], green = light[data[i + 1]], blue = light[data[i + 2]];
    data[i + 3] = 255 * (1 - within(5.5 * (green - 0.35 * red)) * within(6 * (0.5 * red - blue)));
  }
  return made;
}

/** A program of shaders, and the places of its uniforms. */
class Shaders {
  /** Has the program made, without waiting for it: browsers make several at once. */
  constructor(gl, vertex, fragment) {
    this.gl = gl;
    this.program = gl.createProgram();
    this.shaders = [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]].map(([kind, text]) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, kShaderHead + text);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
      return shader;
    });
    gl.linkProgram(this.program);
  }

  /** Waits for the program. Throws an Error with its problem. */
  use() {
    const {gl, program} = this;
    if (this.shaders && !gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      const logs = [...this.shaders.map((shader) => gl.getShaderInfoLog(shader)), gl.getProgramInfoLog(program)];
      throw new Error("A shader isn't accepted: " + logs.filter(Boolean).join("; "));
    }
    this.shaders = null;
    gl.useProgram(program);
  }

  place(name) { return this.gl.getUniformLocation(this.program, name); }
}

class BookView {
  /** `pictures`: {front, spine, back, paper}, loaded. Without WebGL 2 nothing is drawn: see `lack`. */
  constructor(canvas, mesh, pictures, shaders) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", {alpha: false, antialias: false, preserveDrawingBuffer: true, powerPreference: "high-performance"});
    this.make = () => this.#make(mesh, pictures, shaders);
    if (this.gl) this.make();
  }

  /** Returns why nothing is drawn, in words; empty if it is. */
  get lack() {
    if (!this.gl) return say("This browser has no WebGL 2: the book is drawn plainly, and its clip can’t be saved. Perhaps “graphics acceleration” is switched off in its settings.");
    return this.gl.isContextLost() ? say("The graphics were interrupted; the picture comes back as soon as the browser lets it.") : "";
  }

  #make(mesh, pictures, shaders) {
    const gl = this.gl;
    const vertex = shaders.studio_scatter + shaders.book, shine = kSharper + shaders.studio_scatter + shaders.studio_shine;
    this.cover = new Shaders(gl, vertex, shine + shaders.cover + shaders.tone_curve);
    const surface = shine + shaders.surface + shaders.tone_curve;
    this.surfaces = {get shaders() { return this.made ??= new Shaders(gl, vertex, surface); }};
    this.paper = new Shaders(gl, vertex, kSharper + shaders.paper + shaders.tone_curve);
    const backdrop = (name) => new Shaders(gl, shaders.whole_picture, shaders[name]);
    this.backdrops = {studio: backdrop("studio"), get stars() { return this.made ??= backdrop("stars"); }};
    this.#makeGeometry(mesh);
    this.textures = {};
    this.white = null;
    for (const [name, picture] of Object.entries(pictures)) this.textures[name] = name === "paper" ? this.#texture(picture, true) : this.#texture(withGold(picture), false);
    this.noVertices = gl.createVertexArray();
    this.#makeLayers();
    this.setCloth(null);
    this.setBodies(this.bodies?.map((body) => body?.mesh ?? null) ?? []);
  }

  /** The meshes of the bodies that draw() names by number; null for the book. */
  setBodies(meshes) {
    const gl = this.gl;
    if (!gl) return;
    for (const body of this.bodies ?? []) {
      if (!body) continue;
      gl.deleteVertexArray(body.array);
      body.buffers.forEach((buffer) => gl.deleteBuffer(buffer));
    }
    this.white ??= this.#texture(new ImageData(new Uint8ClampedArray([255, 255, 255, 255]), 1, 1), true);
    this.bodies = meshes.map((mesh) => mesh && {mesh, ...this.#uploaded(mesh)});
  }

  #uploaded({vertices, indices}) {
    const gl = this.gl, array = gl.createVertexArray(), buffers = [gl.createBuffer(), gl.createBuffer()];
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers[0]);
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
    this.#describeVertices();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers[1]);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
    return {array, buffers};
  }

  #describeVertices() {
    const gl = this.gl;
    let offset = 0;
    kAttributes.forEach((size, index) => {
      gl.enableVertexAttribArray(index);
      gl.vertexAttribPointer(index, size, gl.FLOAT, false, 52, 4 * offset);
      offset += size;
    });
  }

  #makeGeometry(mesh) {
    const gl = this.gl;
    this.book = gl.createVertexArray();
    gl.bindVertexArray(this.book);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, mesh.vertices, gl.STATIC_DRAW);
    this.#describeVertices();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    const all = kParts.map((part) => mesh.parts[part]);
    const indices = new Uint16Array(all.reduce((sum, part) => sum + part.length, 0));
    this.ranges = {};
    let start = 0;
    kParts.forEach((part, i) => {
      indices.set(all[i], start);
      this.ranges[part] = [start, all[i].length];
      start += all[i].length;
    });
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
  }

  #texture(picture, repeats) {
    const gl = this.gl, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
    gl.generateMipmap(gl.TEXTURE_2D);
    const wrap = repeats ? gl.REPEAT : gl.CLAMP_TO_EDGE;
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wrap);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wrap);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    return texture;
  }

  /** Plain cloth of a colour [0 to 1] in place of the built-in covers; null for these. */
  setCloth(colour) {
    this.scatteredByCloth = (colour ?? [0.45, 0.08, 0.11]).map((part) => part ** 2);
    this.cloth = colour && this.gl && this.#texture(new ImageData(new Uint8ClampedArray([...colour.map((part) => Math.round(255 * part)), 255]), 1, 1), false);
  }

  /** Makes where books are drawn, with several samples of a pixel, and where these are joined: a canvas takes them in its own format alone. */
  #makeLayers() {
    const gl = this.gl, buffer = (format, place, samples) => ({made: gl.createRenderbuffer(), format, place, samples});
    const layer = (...buffers) => ({frame: gl.createFramebuffer(), buffers});
    this.sampled = layer(buffer(gl.RGBA8, gl.COLOR_ATTACHMENT0, kSamples), buffer(gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT, kSamples));
    this.joined = layer(buffer(gl.RGBA8, gl.COLOR_ATTACHMENT0, 0));
    this.size = null;
  }

  #fitLayers() {
    const gl = this.gl, {width, height} = this.canvas, size = `${width} ${height}`;
    if (size === this.size) return;
    this.size = size;
    this.ground = null;
    for (const {frame, buffers} of [this.sampled, this.joined]) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
      for (const {made, format, place, samples} of buffers) {
        gl.bindRenderbuffer(gl.RENDERBUFFER, made);
        gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, made);
      }
    }
  }

  /** Copies a part of a layer to another, or to the canvas if that is null. */
  #copy(from, to, {x, y, width, height}) {
    const gl = this.gl, low = this.canvas.height - y - height, part = [x, low, x + width, low + height];
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from.frame);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to && to.frame);
    gl.blitFramebuffer(...part, ...part, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  }

  /**
   * Draws books or other bodies, each {area: {x, y, width, height} in pixels from the top left, ground: of its
   * backdrop, if that is another, cage, matrix, eye, sky, backdrop, isUnseen}, in the order of setBodies().
   * What is behind them stays on the canvas, but where they were in the last picture.
   */
  draw(books) {
    const gl = this.gl, boxes = books.map(boxOf);
    this.#fitLayers();
    this.#drawGround(books);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.sampled.frame);
    books.forEach((book, i) => {
      this.#clear(book, boxes[i]);
      this.#prepare(book);
      if (book.isUnseen) return;
      if (this.bodies[i]) this.#drawBody(book, this.bodies[i]);
      else this.#drawBook(book);
    });
    gl.disable(gl.SCISSOR_TEST);
    for (const box of boxes) {
      this.#copy(this.sampled, this.joined, box);
      this.#copy(this.joined, null, box);
    }
    this.boxes = boxes;
  }

  #drawGround(books) {
    const gl = this.gl, ground = JSON.stringify([this.isLight, books.map(({area, ground, plain, backdrop, sky}) => [area, ground, plain, backdrop, [...sky]])]);
    const isSame = ground === this.ground;
    this.ground = ground;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    if (!isSame) {
      const {plain, backdrop} = books[0], wall = plain ?? (backdrop === "stars" ? [0, 0, 0] : kWall);
      gl.clearColor(...wall.map((part) => (this.isLight && !plain ? 1 - kLightShare * part : part)), 1);
      gl.clear(gl.COLOR_BUFFER_BIT);
    }
    books.forEach((book, i) => this.#clear(book, isSame ? this.boxes[i] : book.ground ?? book.area));
  }

  /** Draws a part of what is behind a book; then what is drawn is in its area. */
  #clear({area, ground = area, plain, backdrop, sky}, {x, y, width, height}) {
    const gl = this.gl, bottom = this.canvas.height;
    const drawIn = (place) => gl.viewport(place.x, bottom - place.y - place.height, place.width, place.height);
    gl.enable(gl.SCISSOR_TEST);
    drawIn(ground);
    gl.scissor(x, bottom - y - height, width, height);
    gl.clearColor(...(plain ?? [0, 0, 0]), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (!plain) this.#drawBackdrop(this.backdrops[backdrop] ?? this.backdrops.studio, ground.width, ground.height, sky);
    drawIn(area);
  }

  #drawBackdrop(shaders, width, height, sky) {
    const gl = this.gl;
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    shaders.use();
    gl.uniform2f(shaders.place("pictureSize"), width, height);
    gl.uniform1i(shaders.place("supersample"), 1);
    gl.uniformMatrix4fv(shaders.place("skyFromPicture"), false, sky);
    gl.bindVertexArray(this.noVertices);
    if (this.isLight) this.#takeFromWhite();
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.BLEND);
  }

  /** What is drawn next is seen as in a negative, fainter. */
  #takeFromWhite() {
    const gl = this.gl;
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendEquationSeparate(gl.FUNC_REVERSE_SUBTRACT, gl.FUNC_ADD);
    gl.blendColor(kLightShare, kLightShare, kLightShare, 1);
    gl.blendFunc(gl.CONSTANT_COLOR, gl.ONE);
  }

  #prepare(book) {
    const gl = this.gl, winding = windingOf(book.cage);
    gl.enable(gl.DEPTH_TEST);
    if (winding === 0) gl.disable(gl.CULL_FACE);
    else gl.enable(gl.CULL_FACE);
    gl.frontFace(winding < 0 ? gl.CW : gl.CCW);
  }

  #drawBody(book, body) {
    const gl = this.gl, {shaders} = this.surfaces;
    gl.bindVertexArray(body.array);
    this.#use(shaders, book);
    gl.uniform3fv(shaders.place("eye"), book.eye);
    gl.bindTexture(gl.TEXTURE_2D, this.white);
    for (const part of body.mesh.parts) {
      for (const name of ["baseColour", "grainsAcross"]) gl.uniform3fv(shaders.place(name), part[name]);
      for (const name of ["metalAndRoughness", "contrastAndRelief"]) gl.uniform2fv(shaders.place(name), part[name]);
      gl.drawElements(gl.TRIANGLES, part.count, gl.UNSIGNED_INT, 4 * part.first);
    }
  }

  #drawBook(book) {
    const gl = this.gl, winding = windingOf(book.cage);
    gl.bindVertexArray(this.book);
    this.#use(this.cover, book);
    gl.uniform3fv(this.cover.place("eye"), book.eye);
    gl.uniform3fv(this.cover.place("beside"), [0.52, 0.45, 0.33]);
    for (const part of ["front", "spine", "back"]) this.#drawPart(part, this.cloth ?? this.textures[part]);
    if (winding === 0) this.#drawPart("lining", this.cloth ?? this.textures.front);
    this.#use(this.paper, book);
    gl.uniform3fv(this.paper.place("beside"), this.scatteredByCloth);
    this.#drawPart("pages", this.textures.paper);
  }

  #use(shaders, book) {
    shaders.use();
    this.gl.uniform3fv(shaders.place("cage"), book.cage);
    this.gl.uniformMatrix4fv(shaders.place("clipFromWorld"), false, book.matrix);
  }

  #drawPart(part, texture) {
    const gl = this.gl, [start, count] = this.ranges[part];
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_SHORT, 2 * start);
  }
}

#version 330 core
// One triangle that covers the picture.
uniform vec2 pictureSize;  // [pixels]

out vec2 position;  // From the middle, in halves of the picture's shorter side; y down.

void main() {
  vec2 clip = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  position = clip * pictureSize / min(pictureSize.x, pictureSize.y);
  gl_Position = vec4(clip, 1.0, 1.0);  // At the far plane.
#ifdef CLIP_Y_UP  // In a browser the frame buffer's first row is the lowest.
  gl_Position.y = -clip.y;
#endif
}

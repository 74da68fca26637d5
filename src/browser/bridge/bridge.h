// The core as functions of C, for a page in a browser and for other languages. All work on a
// context, which has a buffer; nothing else that they return has to be freed. One thread at a time
// calls functions with the same context; those with different ones share nothing.
//
// Text goes in and out through the buffer, as UTF-8 without a final zero. A function that writes an
// answer there returns its length in bytes; one that can fail returns it negated when the answer is
// the message of an error, the same that the program prints. Addresses stay valid until the next
// call that says otherwise.
//
// A context has kSlots slots: for what is played, for the ghost beside it, and for a clip that is
// proved. A slot holds a scene, and its motions as far as they are simulated.
//
// No call throws. A slot that there isn't, or that holds no scene yet, is an error for functions
// that can fail; the others say what they answer.
#pragma once

#include <cstdint>

extern "C" {

/// Slots are numbered from 0 to below this.
enum { kSlots = 3 };
/// Frames that a slot of a page has room for, of all its motions together: 20 minutes of a book. So
/// many in every slot take up to 205 MiB of the module's 256 (measured; 229 with the text of
/// rb_table_checksum()).
enum { kMaxFrames = 72000 };
/// The size of a page's buffer. [bytes]
enum { kBufferSize = 1 << 20 };

typedef struct rb_context rb_context;
/// Makes a context whose slots have room for so many frames, and whose buffer for so many bytes: of
/// a page if they are 0. rb_delete() frees it, and all that it has answered. Null without memory.
rb_context* rb_new(std::int32_t maxFrames, std::int32_t bufferSize);
void rb_delete(rb_context* context);

/// Returns the address of the buffer, a multiple of 16.
char* rb_buffer(rb_context* context);
/// Returns its size. [bytes]
std::int32_t rb_buffer_size(rb_context* context);

/// Writes JSON of what a page needs to know of scenes: {"version", "models": [{"name",
/// "integrators": [names], "integrator": the default}], "keys": {NAME: {"type": "own", "integer",
/// "number", "vector", "text" or "choice", "unit", "models": those whose motions it changes, "min",
/// "max" (of texts' characters), "choices"}}, "longestScene" [bytes], "maxNudges"}. Returns its
/// length.
std::int32_t rb_words(rb_context* context);

/// Parses the TOML text in the buffer's first `length` bytes and writes it as JSON, as it stands:
/// without defaults. Positive length, or negative with the message.
std::int32_t rb_toml_to_json(rb_context* context, std::int32_t length);
/// Writes the scene that is JSON in the buffer's first `length` bytes, as the above writes it, as
/// TOML. Positive length, or negative with the message.
std::int32_t rb_json_to_toml(rb_context* context, std::int32_t length);

/// Files that rb_file() takes.
enum { kMaxFiles = 16 };
/// Takes a file that scenes may name, a recording, a mesh or words: in the buffer `nameLength`
/// bytes of its name, as scenes write it, then `length` bytes of its own. It takes the place of one
/// of that name, and stays; without a name and without bytes, all files are forgotten. Returns 0;
/// negative with the message if the buffer isn't as large, or there are kMaxFiles others.
std::int32_t rb_file(rb_context* context, std::int32_t nameLength, std::int32_t length);

/// Finds the flight of a toss in readings of seven doubles each: time [s], angular velocity x y z
/// [rad/s], specific force x y z [m/s^2]. Returns the address of `count[0]` doubles, valid until
/// the next call: when it begins and ends, and the angular velocity that it begins with; 0 of them
/// if nothing flew.
const double* rb_flight(rb_context* context, const double* readings, std::int32_t readingCount,
                        std::int32_t* count);
/// Writes JSON of the recording in a file that was taken, by its name in the buffer's first
/// `length` bytes: {"duration" [s], "turning": [from, to], of its times, the longest stretch in
/// which it turns as fast as in a throw, or null}. Positive length; negative with the message.
std::int32_t rb_recording(rb_context* context, std::int32_t length);

/// Reads the scene in the buffer's first `length` bytes into a slot and writes JSON of
/// what follows from it: {"rate": [n, d], "interval": simulated seconds a frame, "motions":
/// [{"label", "model", "body": [x, y, z], "springs": [[i, j, length]], "moments": [3]}],
/// "captions":
/// [[frame, text]]: those in time, in their order}. Positive
/// length; negative with the message, and the slot keeps what it holds. Motions of more than
/// the context's frames are refused. A scene whose scene::motionText() is that of the slot's former
/// one keeps the samples, unless the simulation has failed: so with another camera, look, book,
/// overlay, title, label, expectation, study, picture size or encoding. Any other change begins
/// anew.
std::int32_t rb_read(rb_context* context, std::int32_t slot, std::int32_t length);
/// Writes the slot's scene as TOML with every default explicit. Positive length, or negative with
/// the message.
std::int32_t rb_scene_text(rb_context* context, std::int32_t slot);

/// Simulates the slot's motions up to and including `frame`, or as far as `steps` integration steps
/// go, whichever comes first, but at least one more. Returns the number of frames that are
/// simulated, from 0; -1 if a motion fails, with the message's text after a call of rb_message().
/// One that has failed fails in each later call.
std::int32_t rb_advance(rb_context* context, std::int32_t slot, std::int32_t frame,
                        std::int32_t steps);
/// Writes the message of the last failure of rb_advance(). Returns its length.
std::int32_t rb_message(rb_context* context);
/// Returns the number of frames of the slot's clip; smaller than asked for once all its motions
/// have diverged. 0 without a scene.
std::int32_t rb_frames(rb_context* context, std::int32_t slot);

/// The numbers of a sample, by index: time; attitude w x y z; angular velocity x y z; angular
/// momentum x y z (world axes); kinetic, potential, rotational energy; tilt [degrees]; half-turns;
/// stretch min, max; error [degrees]; regime (1, 0, -1); 1 if the motion has diverged and this is
/// its last sample; corners x y z, eight times.
enum {
  kTime = 0,
  kAttitude = 1,
  kAngularVelocity = 5,
  kAngularMomentum = 8,
  kEnergies = 11,
  kTilt = 14,
  kHalfTurns = 15,
  kStretch = 16,
  kError = 18,
  kRegime = 19,
  kHeld = 20,
  kCorners = 21,
  kSampleNumbers = 45
};
/// Returns the address of kSampleNumbers doubles: the sample of motion `motion` that `frame` shows,
/// or the nearest that is simulated. Valid until the next call. Null if there is no such motion.
const double* rb_sample(rb_context* context, std::int32_t slot, std::int32_t motion,
                        std::int32_t frame);

/// Returns the address of the samples of motion `motion` as they are kept, along the world's axes,
/// `count[0]` of them, one a frame up to its end or where it has diverged; rb_sample_layout() says
/// what is in each. Valid until another scene is read into the slot. Null, and 0, if there is no
/// such motion, or the slot's aren't simulated to their end. Not of a page.
const void* rb_samples(rb_context* context, std::int32_t slot, std::int32_t motion,
                       std::int32_t* count);
/// Writes JSON of such a sample: {"size" [bytes], "fields": {NAME: {"offset" [bytes], "type": "f8"
/// or "i4", "shape": [counts]}}}. Returns its length. Not of a page.
std::int32_t rb_sample_layout(rb_context* context);

/// Writes the checksum of the slot's motions, simulated to their end, as a clip's record has it.
/// Returns its length; negative if they aren't simulated to the end.
std::int32_t rb_checksum(rb_context* context, std::int32_t slot);
/// Writes likewise the checksum of the motions' CSV tables, one after the other.
std::int32_t rb_table_checksum(rb_context* context, std::int32_t slot);

/// The bytes of a clip's file that rb_record() takes at once.
enum { kRecordPiece = 65536 };
/// Begins to look for the record in a clip's file of `size` bytes, an MP4 or a WebM, which may be
/// anything; any other search ends.
void rb_clip(rb_context* context, double size);
/// Returns the offset of the piece of the file that rb_record() takes next. [bytes]
double rb_clip_offset(rb_context* context);
/// Takes the piece that is in the buffer's first `length` bytes: kRecordPiece, or all that are left
/// of the file. Writes the record's text once it is found. Returns its length, 0 before, or
/// negative with the message.
std::int32_t rb_record(rb_context* context, std::int32_t length);

/// Returns the address of the book's mesh: `count[0]` vertices of 13 floats (position in the unit
/// cube, normal, texture coordinate, sky visibility, surface number, MeshVertex::away), and by
/// rb_mesh_indices() the indices of part `part` (front, spine, back, pages, lining), three a
/// triangle; null, and 0 of them, of another part.
const float* rb_mesh_vertices(rb_context* context, std::int32_t* count);
const std::uint16_t* rb_mesh_indices(rb_context* context, std::int32_t part, std::int32_t* count);

/// Writes JSON of the body of motion `motion`: null of the book, else {"vertices": count,
/// "indices": count, "parts": [{"first", "count", "baseColour": [3], "metalAndRoughness": [2],
/// "grainsAcross": [3], "contrastAndRelief": [2]}]}; `first` and `count` are of indices, the others
/// are surface.frag's. A mesh whose file wasn't taken is a box of its size. Positive length, or
/// negative with the message.
std::int32_t rb_body(rb_context* context, std::int32_t slot, std::int32_t motion);
/// Return the addresses of the vertices, 13 floats each as rb_mesh_vertices() has them, and of the
/// indices of the body of the last rb_body().
const float* rb_body_vertices(rb_context* context);
const std::uint32_t* rb_body_indices(rb_context* context);

/// Writes to `matrix` (16 floats, column by column) the projection of world to clip space of the
/// slot's camera as it is in `frame` for motion `motion`, with clip y up, for a picture of this
/// shape; to `eye` (3 floats) its position; and to `sky` (16 floats) geometry::skyFromPicture() of
/// a camera that turns or moves, 0 of others. `orbit` turns it by so many radians about its up
/// direction and then about its right, and `distance` multiplies its distance from the target.
/// Returns 1; 0 without writing anything if there is no such motion. A frame outside the clip is
/// taken for the nearest, a side of the picture that is no number from 1 for 1.
std::int32_t rb_camera(rb_context* context, std::int32_t slot, std::int32_t motion,
                       std::int32_t frame, float width, float height, const double* orbit,
                       double distance, float* matrix, float* eye, float* sky);

/// The numbers by which clips say why a body turns over, of motion `motion` in `frame`, along the
/// axes of the slot's camera. Each function returns the address of `count[0]` doubles, valid until
/// the next call; null, and 0 of them, if there is no such motion.
///
/// Forces on the body's masses: the one that has the longest arrow, then for each mass its place
/// [m], what the body does to it, centrifugal, Coriolis and Euler force [N/kg], x y z each.
const double* rb_forces(rb_context* context, std::int32_t slot, std::int32_t motion,
                        std::int32_t frame, std::int32_t* count);
/// The ladder of energies. Heights are from 0, the largest moment's axis, to 1, the smallest's;
/// angles of the momentum L to the axis that it circles are in half turns. The height, greatest
/// angle and angle of now, and the energy above the middle axis' [%]; for the axes of the smallest,
/// middle and largest moment the axis (0 to 2), 1 if it isn't one of the body's, height and
/// greatest angle; then the outline, height and greatest angle from the top down.
const double* rb_ladder(rb_context* context, std::int32_t slot, std::int32_t motion,
                        std::int32_t frame, std::int32_t* count);
/// Samples before `frame` that rb_poinsot() looks back to at most.
enum { kMaxTrail = 3600 };
/// Poinsot's construction [m], none of a body at rest: the distance of the plane from the centre,
/// the least and the greatest radius of the herpolhode, the ellipsoid's longest semi-axis; the
/// centre; the map from the unit sphere to the ellipsoid, column by column; two unit vectors in the
/// plane, and its normal; then, of `trail` samples before `frame` and of its own, the points of
/// polhode and herpolhode, since the last nudge.
const double* rb_poinsot(rb_context* context, std::int32_t slot, std::int32_t motion,
                         std::int32_t frame, std::int32_t trail, std::int32_t* count);
/// Writes JSON of the spin that motion `motion` starts with, that of a rigid body: {"speed"
/// [rad/s], "axis": "smallest", "middle" or "largest", the nearest, "offAxis": the angle to it
/// [degrees], "circled": the axis that L circles, "isSteady", "hasEqualMoments", "flipInterval" and
/// "firstFlip" [s] or null}. Positive length, or negative with the message.
std::int32_t rb_spin(rb_context* context, std::int32_t slot, std::int32_t motion);

}  // extern "C"

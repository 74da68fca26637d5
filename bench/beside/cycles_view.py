"""Run by Blender: path traces an exported book in rotatebook's studio.

blender --background --python-exit-code 1 --python cycles_view.py -- VIEW.glb OUTPUT.npy WIDTH HEIGHT SAMPLES

Writes WIDTH x HEIGHT x 4 32-bit floats, the uppermost row first: linear red, green, blue, premultiplied, and alpha.
"""
import os
import sys
import tempfile

import bpy
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import studio

np.bool = bool  # Which the importer of Blender 3.4 asks for, and newer versions of NumPy lack.

STUDIO_HEIGHT = 512  # Of the studio as a map, which is twice as wide. [pixels]
ASSETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../assets")
CLOTH_ROUGHNESS, GOLD_ROUGHNESS = 0.45, 0.26


def studio_map():
    """Returns the studio as Blender's equirectangular map, the lowest row first; Blender's z is up, -y is ahead."""
    height, width = STUDIO_HEIGHT, 2 * STUDIO_HEIGHT
    v, u = np.meshgrid((np.arange(height) + 0.5) / height, (np.arange(width) + 0.5) / width, indexing="ij")
    latitude, longitude = np.pi * (v - 0.5), -2 * np.pi * (u - 0.5)
    x, y, z = np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)
    light = studio.radiance(np.stack([x, z, -y], -1).reshape(-1, 3))
    return np.concatenate([light, np.ones((len(light), 1))], 1).astype(np.float32)


def light_by_studio(scene):
    image = bpy.data.images.new("studio", 2 * STUDIO_HEIGHT, STUDIO_HEIGHT, alpha=False, float_buffer=True)
    image.colorspace_settings.name = "Linear"
    image.pixels.foreach_set(studio_map().ravel())
    scene.world = bpy.data.worlds.new("studio")
    scene.world.use_nodes = True
    nodes = scene.world.node_tree.nodes
    environment = nodes.new("ShaderNodeTexEnvironment")
    environment.image = image
    scene.world.node_tree.links.new(environment.outputs["Color"], nodes["Background"].inputs["Color"])


def number(nodes, links, operation, *inputs, clamp=False):
    """Adds a node that computes with numbers or others' outputs; returns its output."""
    node = nodes.new("ShaderNodeMath")
    node.operation, node.use_clamp = operation, clamp
    for socket, value in zip(node.inputs, inputs):
        if isinstance(value, (int, float)):
            socket.default_value = value
        else:
            links.new(value, socket)
    return node.outputs[0]


def stamp_gold(material):
    """Gives a cover its whole picture, as what is exported is half as fine, and makes what is golden in it a metal, as
    withGold() of src/platform/render/book_textures.cpp has it."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    surface = nodes["Principled BSDF"]
    colour = surface.inputs["Base Color"].links[0].from_socket
    colour.node.image = bpy.data.images.load(os.path.join(ASSETS, material.name + ".png"))
    parts = nodes.new("ShaderNodeSeparateColor")
    links.new(colour, parts.inputs[0])
    red, green, blue = parts.outputs[:3]
    yellow = number(nodes, links, "MULTIPLY", 5.5, number(nodes, links, "SUBTRACT", green, number(
        nodes, links, "MULTIPLY", 0.35, red)), clamp=True)
    warm = number(nodes, links, "MULTIPLY", 6, number(nodes, links, "SUBTRACT", number(
        nodes, links, "MULTIPLY", 0.5, red), blue), clamp=True)
    gold = number(nodes, links, "MULTIPLY", yellow, warm)
    links.new(gold, surface.inputs["Metallic"])
    smoother = number(nodes, links, "MULTIPLY", GOLD_ROUGHNESS - CLOTH_ROUGHNESS, gold)
    links.new(number(nodes, links, "ADD", CLOTH_ROUGHNESS, smoother), surface.inputs["Roughness"])


def connect(links, source, target):
    """Gives an input what another has: its link, or its number."""
    if source.links:
        links.new(source.links[0].from_socket, target)
    else:
        target.default_value = source.default_value


def scatter_evenly(material):
    """Makes the material glTF's, whose matt part is Lambert's.

    That of the Principled BSDF before Blender 4 is Disney's, which shines at grazing views: rough paper by a third.
    """
    nodes, links = material.node_tree.nodes, material.node_tree.links
    metal = nodes["Principled BSDF"]
    glaze, matt = nodes.new("ShaderNodeBsdfPrincipled"), nodes.new("ShaderNodeBsdfDiffuse")
    coated, whole = nodes.new("ShaderNodeAddShader"), nodes.new("ShaderNodeMixShader")
    glaze.inputs["Base Color"].default_value = (0, 0, 0, 1)
    connect(links, metal.inputs["Roughness"], glaze.inputs["Roughness"])
    connect(links, metal.inputs["Base Color"], matt.inputs["Color"])
    connect(links, metal.inputs["Metallic"], whole.inputs["Fac"])
    for link in metal.inputs["Metallic"].links:
        links.remove(link)
    metal.inputs["Metallic"].default_value = 1
    links.new(matt.outputs[0], coated.inputs[0])
    links.new(glaze.outputs[0], coated.inputs[1])
    links.new(coated.outputs[0], whole.inputs[1])
    links.new(metal.outputs[0], whole.inputs[2])
    links.new(whole.outputs[0], nodes["Material Output"].inputs["Surface"])


def main():
    source, output, width, height, samples = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=source)
    scene = bpy.context.scene
    scene.frame_set(0)
    scene.camera = next(thing for thing in scene.objects if thing.type == "CAMERA")
    light_by_studio(scene)
    for material in bpy.data.materials:
        if material.name in ("front", "spine", "back"):
            stamp_gold(material)
        if material.use_nodes:
            scatter_evenly(material)
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.seed = int(samples), False, 1
    scene.render.film_transparent = True
    scene.render.resolution_x, scene.render.resolution_y = int(width), int(height)
    scene.view_settings.view_transform = "Raw"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth, scene.render.image_settings.color_mode = "32", "RGBA"
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = os.path.join(folder, "view.exr")
        bpy.ops.render.render(write_still=True)
        picture = bpy.data.images.load(scene.render.filepath)
        picture.alpha_mode = "PREMUL"
        pixels = np.empty(len(picture.pixels), np.float32)
        picture.pixels.foreach_get(pixels)
    np.save(output, pixels.reshape(int(height), int(width), 4)[::-1])


main()

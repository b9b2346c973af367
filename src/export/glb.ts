/**
 * GLB: binary glTF 2.0, in metres as that format demands. A node with a mesh a part, a material a colour and finish, normals and
 * texture coordinates; painted parts have their colours by vertex, over white. The library that writes it is fetched when the first file is written.
 */
import type { Accessor, Buffer, Document, Material } from '@gltf-transform/core';
import { isPlainFinish } from '../document/finish.ts';
import { linearRgb } from './colour.ts';
import type { Exporter } from './index.ts';
import { materialsOf, metalnessOf, roughnessOf, type Material as Worn } from './material.ts';
import { fileName } from './names.ts';
import { type FilePart, fileParts } from './parts.ts';

export const glb: Exporter = {
  id: 'glb',
  label: 'glTF binary (GLB)',
  carries: 'named parts, normals, texture coordinates, colours; metres',
  mime: 'model/gltf-binary',
  async write(model) {
    const { Document, WebIO } = await import('@gltf-transform/core');
    const document = fill(new Document(), fileParts(model));
    const bytes = await new WebIO().writeBinary(document);
    return [{ name: `${fileName(model.name)}.glb`, bytes }];
  },
};

const METRES = 0.001;

function fill(document: Document, parts: readonly FilePart[]): Document {
  document.getRoot().getAsset().generator = 'Rotund';
  // A scene without nodes is not valid.
  if (parts.length === 0) return document;
  const scene = document.createScene();
  document.getRoot().setDefaultScene(scene);
  const buffer = document.createBuffer();
  const worn = materialsOf(parts);
  const materials = new Map<Worn, Material>();
  for (const [i, part] of parts.entries()) {
    const material = materials.get(worn[i]!) ?? materialOf(document, worn[i]!);
    materials.set(worn[i]!, material);
    scene.addChild(nodeOf(document, buffer, part, material));
  }
  return document;
}

function materialOf(document: Document, { name, colour, finish }: Worn): Material {
  const [red, green, blue] = linearRgb(colour).map((value) => Math.min(1, value * finish.diffuse));
  return (
    document
      .createMaterial(isPlainFinish(finish) ? colour : name)
      .setBaseColorFactor([red!, green!, blue!, 1])
      .setMetallicFactor(metalnessOf(finish))
      .setRoughnessFactor(roughnessOf(finish))
      // as in the program: a form without caps is seen from within, too
      .setDoubleSided(true)
  );
}

function nodeOf(document: Document, buffer: Buffer, { name, mesh }: FilePart, material: Material) {
  const accessor = (type: 'SCALAR' | 'VEC2' | 'VEC3', array: Uint32Array | Float32Array): Accessor =>
    document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const primitive = document
    .createPrimitive()
    .setMaterial(material)
    .setIndices(accessor('SCALAR', mesh.indices))
    .setAttribute(
      'POSITION',
      accessor(
        'VEC3',
        mesh.positions.map((x) => x * METRES + 0),
      ),
    )
    .setAttribute(
      'NORMAL',
      accessor(
        'VEC3',
        mesh.normals.map((x) => x + 0),
      ),
    )
    .setAttribute('TEXCOORD_0', accessor('VEC2', mesh.uvs.map(fromUpperLeft)));
  if (mesh.colours) primitive.setAttribute('COLOR_0', accessor('VEC3', mesh.colours.map(clamped)));
  return document.createNode(name).setMesh(document.createMesh(name).addPrimitive(primitive));
}

const clamped = (light: number): number => Math.min(1, Math.max(0, light));

/** glTF counts v from the upper edge of a picture, the other formats and we from the lower one. */
const fromUpperLeft = (value: number, i: number): number => (i % 2 ? 1 - value : value);

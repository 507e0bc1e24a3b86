// Frames with smooth edges, and rough ones. A program that draws without a graphics card takes twice as long for smooth
// edges: there a change is drawn rough, and smooth once nothing has changed for a while.
import * as THREE from "three";
import { FullScreenQuad } from "three/examples/jsm/postprocessing/Pass.js";

const samples = 4;
// Milliseconds.
const quickSmooth = 50;    // frames as short as this are smooth at once
const quickRough = 15;     // and after rough ones as short as this
const longestRough = 400;  // after longer ones a smooth one would keep the next change waiting
const calm = 500;          // without a frame, a move of the pointer or a key, which tell of a change to come
const glance = 4;          // between two looks whether a frame is done

const copy = {
  glslVersion: THREE.GLSL3,
  vertexShader: "in vec3 position; void main() { gl_Position = vec4(position, 1.0); }",
  fragmentShader: `precision highp float; uniform sampler2D uFrame; out vec4 colour;
    void main() { colour = texelFetch(uFrame, ivec2(gl_FragCoord.xy), 0); }`,
  blending: THREE.NoBlending,
  depthTest: false,
  depthWrite: false,
};

export class Smoothing {
  private readonly target = new THREE.WebGLRenderTarget(1, 1, { samples });
  private readonly quad = new FullScreenQuad(new THREE.RawShaderMaterial({ ...copy, uniforms: { uFrame: { value: this.target.texture } } }));
  private isQuick = false;
  private timer = 0;
  private frame = 0;

  // `again` draws a smooth frame in place of a rough one.
  constructor(private readonly renderer: THREE.WebGLRenderer, private readonly again: () => void) {
    for (const name of ["pointermove", "keydown"]) window.addEventListener(name, () => this.timer !== 0 && this.wait(), true);
  }

  draw(scene: THREE.Scene, camera: THREE.Camera, isSmooth: boolean): void {
    isSmooth ||= this.isQuick;
    if (isSmooth) this.drawSmooth(scene, camera);
    else this.renderer.render(scene, camera);
    this.forget();
    const frame = ++this.frame;
    this.whenDone((took) => {
      this.isQuick = took < (isSmooth ? quickSmooth : quickRough);
      if (!isSmooth && took < longestRough && frame === this.frame) this.wait();
    });
  }

  private wait(): void {
    this.forget();
    this.timer = window.setTimeout(this.again, calm);
  }

  private forget(): void {
    window.clearTimeout(this.timer);
    this.timer = 0;
  }

  private drawSmooth(scene: THREE.Scene, camera: THREE.Camera): void {
    const size = this.renderer.getDrawingBufferSize(new THREE.Vector2());
    this.target.setSize(size.x, size.y);
    this.renderer.setRenderTarget(this.target);
    this.renderer.render(scene, camera);
    this.renderer.setRenderTarget(null);
    this.quad.render(this.renderer);
  }

  // Calls `take` with the milliseconds from now until all that was asked for is drawn.
  private whenDone(take: (took: number) => void): void {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    gl.flush();
    const began = performance.now();
    const look = () => {
      if (gl.isContextLost()) return;
      if (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
        window.setTimeout(look, glance);
        return;
      }
      gl.deleteSync(fence);
      take(performance.now() - began);
    };
    window.setTimeout(look, glance);
  }
}

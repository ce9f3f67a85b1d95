/*! This page holds the following libraries.

three 0.187.0 (MIT)

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot 1.6.32 (MIT)

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
function k(n,t={},...e){let i=document.createElement(n);return C_(i,t),i.append(...e.flat(1/0).filter(s=>s!=null&&s!==!1)),i}var A_="http://www.w3.org/2000/svg";function ja(n,t={},...e){let i=document.createElementNS(A_,n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return i.append(...e.flat(1/0)),i}function C_(n,t){for(let[e,i]of Object.entries(t))i==null||i===!1||(e.startsWith("on")?n.addEventListener(e.slice(2),i):e==="text"?n.textContent=i:e==="class"?n.className=i:e in n&&!e.startsWith("aria")&&e!=="list"?n[e]=i:n.setAttribute(e,i===!0?"":i))}var R_=0,cr=n=>`${n}-${R_+=1}`,Fn="\u2013",At=(n,t=4)=>Number.isFinite(n)?n.toFixed(t):Fn,Qa=(n,t=3)=>Number.isFinite(n)?n.toFixed(t):Fn,ne=n=>n.toLocaleString("en-US"),we=(n,t)=>`${ne(n)} ${t}${n===1?"":"s"}`;function ye(n){if(n==null||!Number.isFinite(n))return Fn;let t=Math.abs(n);return n!==0&&(t<.001||t>=1e6)?n.toExponential(2):String(Number(n.toPrecision(5)))}function $o(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}var Pd=globalThis.requestIdleCallback??(n=>setTimeout(()=>n({timeRemaining:()=>5}),100));function tl(n,t){let e=0,i=s=>{for(;e<n&&s.timeRemaining()>2;e+=1)t(e);e<n&&Pd(i)};Pd(i)}function Gr(n){let t=[];return{...n,set(e){let i=Object.keys(e).filter(s=>this[s]!==e[s]);if(i.length!==0){Object.assign(this,e);for(let[s,r]of t)s.some(o=>i.includes(o))&&r(this)}},on(e,i){t.push([e.split(" "),i])}}}var P_=[0,0,0],el=class{constructor(t){let{course:e,points:i}=t;this.t=e.t,this.shares=e.shares,this.offsets=e.offsets,this.hasModel=e.has_model,this.model=t.model??null,this.from=e.from_c??0,this.byTemperature=e.from_c!==null&&e.from_c!==void 0,this.unit=this.byTemperature?"\xB0C":"min",this.end=this.t[this.t.length-1],this.points=i,this.count=i.motion.length,this.nodes=this.shares.length}at(t){let e=this.t.length-1,i=Math.min(Math.max(t/this.end*e,0),e),s=Math.min(Math.floor(i),e-1),r=i-s;return this.shares.map(o=>o[s]+(o[s+1]-o[s])*r)}get isByTarget(){return this.model!==null&&this.model.still.columns.length+this.model.moving.columns.length>0}deviation(t,e){let i=this.at(e);if(!this.model)return{turns:null,offsets:this.offsets[0].map((u,f)=>u.map((h,d)=>i.reduce((g,v,m)=>g+v*this.offsets[m][f][d],0)))};let{common:s,still:r,moving:o}=this.model,a=s[0].map((u,f)=>i.reduce((h,d,g)=>h+d*s[g][f],0)),{length:l}=r.columns;r.columns.forEach((u,f)=>{a[u]=r.values[t*l+f]});let{length:c}=o.columns;return o.columns.forEach((u,f)=>{a[u]=i.reduce((h,d,g)=>h+d*o.values[(t*this.nodes+g)*c+f],0)}),{turns:a.slice(0,6),offsets:Array.from({length:7},(u,f)=>a.slice(6+6*f,12+6*f))}}error(t,e,i=[0,0,0],s=0){let{e_mm:r}=this.points;for(let o=0;o<3;o+=1){let a=0;for(let l=0;l<this.nodes;l+=1)a+=e[l]*r[(t*this.nodes+l)*3+o];i[s+o]=a}return i}position(t){return this.points.p_mm.slice(3*t,3*t+3)}joints(t){return this.points.q_deg.slice(6*t,6*t+6)}tool(t){return this.points.tools[this.points.tool[t]]??P_}},nl=class{constructor(t,e){this.course=t,this.buckets=e.buckets.map(i=>({...i,shares:t.at(i.at_min)})),this.left=e.worst_after_mm}get inBuckets(){return this.buckets.length>0}bucketAt(t){return this.buckets.find(e=>e.to_min===null||t<e.to_min)??null}leftShares(t){let e=this.course.at(t),i=this.bucketAt(t);return i?e.map((s,r)=>s-i.shares[r]):e.map(()=>0)}correctedShares(t){return this.bucketAt(t)?.shares??this.course.at(t)}},xi=([n,t,e])=>Math.hypot(n,t,e);function Id(n,t,e){let i=I_(n),s=r=>{if(n.nodes===1)return Math.abs(r[0])*i[0];let o=0,a=[0,0,0];for(let l=0;l<n.count;l+=1)n.error(l,r,a),o=Math.max(o,a[0]*a[0]+a[1]*a[1]+a[2]*a[2]);return Math.sqrt(o)};return{before:e.map(r=>s(n.at(r))),after:t.inBuckets?e.map(r=>s(t.leftShares(r))):null}}function I_(n){let t=new Array(n.nodes).fill(0);for(let e=0;e<n.count;e+=1)for(let i=0;i<n.nodes;i+=1){let s=(e*n.nodes+i)*3;t[i]=Math.max(t[i],xi(n.points.e_mm.slice(s,s+3)))}return t}var hr=Math.PI/180,Hh=()=>[1,0,0,0,0,1,0,0,0,0,1,0];function fs(n,t){let e=new Array(12);for(let i=0;i<12;i+=4)for(let s=0;s<4;s+=1)e[i+s]=n[i]*t[s]+n[i+1]*t[4+s]+n[i+2]*t[8+s]+(s===3?n[i+3]:0);return e}var Wh=(n,[t,e,i])=>[n[0]*t+n[1]*e+n[2]*i+n[3],n[4]*t+n[5]*e+n[6]*i+n[7],n[8]*t+n[9]*e+n[10]*i+n[11]],Gh=([n,t,e])=>[1,0,0,n,0,1,0,t,0,0,1,e];function ur([n,t,e],i){let s=Math.cos(i),r=Math.sin(i),o=1-s;return[s+n*n*o,n*t*o-e*r,n*e*o+t*r,0,t*n*o+e*r,s+t*t*o,t*e*o-n*r,0,e*n*o-t*r,e*t*o+n*r,s+e*e*o,0]}var Ld=[1,0,0],Dd=[0,1,0],Nd=[0,0,1],L_=([n,t,e])=>fs(ur(Nd,e*hr),fs(ur(Dd,t*hr),ur(Ld,n*hr))),D_=([n,t,e])=>fs(ur(Ld,n*hr),fs(ur(Dd,t*hr),ur(Nd,e*hr)));function il(n){let t=({origin_mm:i,rpy_deg:s})=>({place:Gh(i),turned:L_(s)});return{joints:n.joint.map(i=>({frame:t(i),axis:i.axis,slides:i.type==="prismatic",range:i.range_deg??i.range_mm})),flange:t(n.flange)}}function Ud(n,t,{offsets:e=null,turns:i=null}={},s=1){let r=[],o=Hh(),a=({place:l,turned:c},u)=>{if(o=fs(o,l),u){let f=u.map(h=>h*s);o=fs(o,fs(Gh(f.slice(0,3)),D_(f.slice(3))))}o=fs(o,c)};return n.joints.forEach((l,c)=>{a(l.frame,e?.[c]);let u=t[c]+(i?.[c]??0)*s;o=fs(o,l.slides?Gh(l.axis.map(f=>f*u)):ur(l.axis,u*hr)),r.push(o)}),a(n.flange,e?.[n.joints.length]),r.push(o),r}var Zs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Js={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},pp=0,Su=1,mp=2;var wa=1,gp=2,_o=3,Ks=0,jn=1,ts=2,_r=0,xo=1,Mu=2,bu=3,wu=4,_p=5;var xr=100,xp=101,vp=102,yp=103,Sp=104,Mp=200,bp=201,wp=202,Tp=203,Tu=204,Eu=205,Ep=206,Ap=207,Cp=208,Rp=209,Pp=210,Ip=211,Lp=212,Dp=213,Np=214,Pl=0,Il=1,Ll=2,io=3,Dl=4,Nl=5,Ul=6,Fl=7,hc=0,Up=1,Fp=2,es=0,Au=1,Cu=2,Ru=3,Pu=4,Iu=5,Lu=6,Du=7;var Nu=300,vr=301,vo=302,uc=303,fc=304,Ol=1e3,Zi=1001,Bl=1002,In=1003,Op=1004;var Ta=1005;var Jn=1006,dc=1007;var bs=1008;var ti=1009,Uu=1010,Fu=1011,yo=1012,pc=1013,Di=1014,Ni=1015,Ui=1016,mc=1017,gc=1018,yr=1020,Ou=35902,Bu=35899,ku=1021,zu=1022,Fi=1023,vs=1026,ws=1027,Vu=1028,_c=1029,js=1030,xc=1031;var vc=1033,Ea=33776,Aa=33777,Ca=33778,Ra=33779,yc=35840,Sc=35841,Mc=35842,bc=35843,wc=36196,Tc=37492,Ec=37496,Ac=37488,Cc=37489,Pa=37490,Rc=37491,Pc=37808,Ic=37809,Lc=37810,Dc=37811,Nc=37812,Uc=37813,Fc=37814,Oc=37815,Bc=37816,kc=37817,zc=37818,Vc=37819,Gc=37820,Hc=37821,Wc=36492,Xc=36494,$c=36495,qc=36283,Yc=36284,Ia=36285,Zc=36286;var ea=2300,kl=2301,Cl=2302,fu=2303,du=2400,pu=2401,mu=2402;var Bp=3200;var Jc=0,kp=1,Ts="",ci="srgb",na="srgb-linear",ia="linear",Pe="srgb";var Rl=7680;var zp=519,Vp=512,Gp=513,Hp=514,Gu=515,Wp=516,Xp=517,Hu=518,Wu=519,$p=35044;var Xu="300 es",yi=2e3,so=2001;function N_(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function U_(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function sa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function qp(){let n=sa("canvas");return n.style.display="block",n}var Fd={},ro=null;function $u(...n){let t="THREE."+n.shift();ro?ro("log",t,...n):console.log(t,...n)}function Yp(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function qt(...n){n=Yp(n);let t="THREE."+n.shift();if(ro)ro("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function te(...n){n=Yp(n);let t="THREE."+n.shift();if(ro)ro("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function jo(...n){let t=n.join(" ");t in Fd||(Fd[t]=!0,qt(...n))}function Zp(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Jp={[Pl]:Pl,[Ll]:Ul,[Dl]:Dl,[io]:Nl,[Il]:Il,[Ul]:Ll,[Fl]:Fl,[Nl]:io},Li=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Od=1234567,Qo=Math.PI/180,oo=180/Math.PI;function So(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]+"-"+Bn[t&255]+Bn[t>>8&255]+"-"+Bn[t>>16&15|64]+Bn[t>>24&255]+"-"+Bn[e&63|128]+Bn[e>>8&255]+"-"+Bn[e>>16&255]+Bn[e>>24&255]+Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]).toLowerCase()}function _e(n,t,e){return Math.max(t,Math.min(e,n))}function qu(n,t){return(n%t+t)%t}function F_(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function O_(n,t,e){return n!==t?(e-n)/(t-n):0}function ta(n,t,e){return(1-e)*n+e*t}function B_(n,t,e,i){return ta(n,t,1-Math.exp(-e*i))}function k_(n,t=1){return t-Math.abs(qu(n,t*2)-t)}function z_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function V_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function G_(n,t){return n+Math.floor(Math.random()*(t-n+1))}function H_(n,t){return n+Math.random()*(t-n)}function W_(n){return n*(.5-Math.random())}function X_(n){n!==void 0&&(Od=n);let t=Od+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function $_(n){return n*Qo}function q_(n){return n*oo}function Y_(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Z_(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Yu(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function J_(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),f=r((t-i)/2),h=o((t-i)/2),d=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*g,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*g,a*c);break;case"ZYZ":n.set(l*g,l*d,a*u,a*c);break;default:qt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Zu(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Kp(n,t){if(t.constructor===Float32Array)return n;let e=Zu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function jp(n,t){if(t.constructor===Float32Array)return n;let e=Zu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Ju={DEG2RAD:Qo,RAD2DEG:oo,generateUUID:So,clamp:_e,euclideanModulo:qu,mapLinear:F_,inverseLerp:O_,lerp:ta,damp:B_,pingpong:k_,smoothstep:z_,smootherstep:V_,randInt:G_,randFloat:H_,randFloatSpread:W_,seededRandom:X_,degToRad:$_,radToDeg:q_,isPowerOfTwo:Y_,ceilPowerOfTwo:Z_,floorPowerOfTwo:Yu,setQuaternionFromProperEuler:J_,normalize:jp,denormalize:Kp},ef=class ef{constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=_e(this.x,t.x,e.x),this.y=_e(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=_e(this.x,t,e),this.y=_e(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_e(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(_e(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};ef.prototype.isVector2=!0;var Jt=ef,zn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],g=r[o+2],v=r[o+3];if(f!==v||l!==h||c!==d||u!==g){let m=l*h+c*d+u*g+f*v;m<0&&(h=-h,d=-d,g=-g,v=-v,m=-m);let p=1-a;if(m<.9995){let y=Math.acos(m),A=Math.sin(y);p=Math.sin(p*y)/A,a=Math.sin(a*y)/A,l=l*p+h*a,c=c*p+d*a,u=u*p+g*a,f=f*p+v*a}else{l=l*p+h*a,c=c*p+d*a,u=u*p+g*a,f=f*p+v*a;let y=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=y,c*=y,u*=y,f*=y}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=f}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*f+l*d-c*h,t[e+1]=l*g+u*h+c*f-a*d,t[e+2]=c*g+u*d+a*h-l*f,t[e+3]=u*g-a*f-l*h-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*g,this._y=c*d*f-h*u*g,this._z=c*u*g+h*d*f,this._w=c*u*f-h*d*g;break;case"YXZ":this._x=h*u*f+c*d*g,this._y=c*d*f-h*u*g,this._z=c*u*g-h*d*f,this._w=c*u*f+h*d*g;break;case"ZXY":this._x=h*u*f-c*d*g,this._y=c*d*f+h*u*g,this._z=c*u*g+h*d*f,this._w=c*u*f-h*d*g;break;case"ZYX":this._x=h*u*f-c*d*g,this._y=c*d*f+h*u*g,this._z=c*u*g-h*d*f,this._w=c*u*f+h*d*g;break;case"YZX":this._x=h*u*f+c*d*g,this._y=c*d*f+h*u*g,this._z=c*u*g-h*d*f,this._w=c*u*f-h*d*g;break;case"XZY":this._x=h*u*f-c*d*g,this._y=c*d*f-h*u*g,this._z=c*u*g+h*d*f,this._w=c*u*f+h*d*g;break;default:qt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],f=e[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(_e(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},nf=class nf{constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Bd.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Bd.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),f=2*(r*i-o*e);return this.x=e+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=_e(this.x,t.x,e.x),this.y=_e(this.y,t.y,e.y),this.z=_e(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=_e(this.x,t,e),this.y=_e(this.y,t,e),this.z=_e(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_e(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Xh.copy(this).projectOnVector(t),this.sub(Xh)}reflect(t){return this.sub(Xh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(_e(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};nf.prototype.isVector3=!0;var Y=nf,Xh=new Y,Bd=new zn,sf=class sf{constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],g=i[8],v=s[0],m=s[3],p=s[6],y=s[1],A=s[4],M=s[7],R=s[2],E=s[5],_=s[8];return r[0]=o*v+a*y+l*R,r[3]=o*m+a*A+l*E,r[6]=o*p+a*M+l*_,r[1]=c*v+u*y+f*R,r[4]=c*m+u*A+f*E,r[7]=c*p+u*M+f*_,r[2]=h*v+d*y+g*R,r[5]=h*m+d*A+g*E,r[8]=h*p+d*M+g*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,g=e*f+i*h+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return t[0]=f*v,t[1]=(s*c-u*i)*v,t[2]=(a*i-s*o)*v,t[3]=h*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=d*v,t[7]=(i*l-c*e)*v,t[8]=(o*e-i*r)*v,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return jo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply($h.makeScale(t,e)),this}rotate(t){return jo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply($h.makeRotation(-t)),this}translate(t,e){return jo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply($h.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}};sf.prototype.isMatrix3=!0;var ie=sf,$h=new ie,kd=new ie().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),zd=new ie().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function K_(){let n={enabled:!0,workingColorSpace:na,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pe&&(s.r=xs(s.r),s.g=xs(s.g),s.b=xs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pe&&(s.r=no(s.r),s.g=no(s.g),s.b=no(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ts?ia:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[na]:{primaries:t,whitePoint:i,transfer:ia,toXYZ:kd,fromXYZ:zd,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ci},outputColorSpaceConfig:{drawingBufferColorSpace:ci}},[ci]:{primaries:t,whitePoint:i,transfer:Pe,toXYZ:kd,fromXYZ:zd,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ci}}}),n}var Se=K_();function xs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function no(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Hr,zl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Hr===void 0&&(Hr=sa("canvas")),Hr.width=t.width,Hr.height=t.height;let s=Hr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Hr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=sa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=xs(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(xs(e[i]/255)*255):e[i]=xs(e[i]);return{data:e,width:t.width,height:t.height}}else return qt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},j_=0,ao=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:j_++}),this.uuid=So(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(qh(s[o].image)):r.push(qh(s[o]))}else r=qh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function qh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?zl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(qt("Texture: Unable to serialize Texture."),{})}var Q_=0,Yh=new Y,Kn=class n extends Li{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Zi,s=Zi,r=Jn,o=bs,a=Fi,l=ti,c=n.DEFAULT_ANISOTROPY,u=Ts){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Q_++}),this.uuid=So(),this.name="",this.source=new ao(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Jt(0,0),this.repeat=new Jt(1,1),this.center=new Jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ie,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Yh).x}get height(){return this.source.getSize(Yh).y}get depth(){return this.source.getSize(Yh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){qt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Nu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ol:t.x=t.x-Math.floor(t.x);break;case Zi:t.x=t.x<0?0:1;break;case Bl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ol:t.y=t.y-Math.floor(t.y);break;case Zi:t.y=t.y<0?0:1;break;case Bl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=Nu;Kn.DEFAULT_ANISOTROPY=1;var rf=class rf{constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,M=(d+1)/2,R=(p+1)/2,E=(u+h)/4,_=(f+v)/4,T=(g+m)/4;return A>M&&A>R?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=E/i,r=_/i):M>R?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=E/s,r=T/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=_/r,s=T/r),this.set(i,s,r,e),this}let y=Math.sqrt((m-g)*(m-g)+(f-v)*(f-v)+(h-u)*(h-u));return Math.abs(y)<.001&&(y=1),this.x=(m-g)/y,this.y=(f-v)/y,this.z=(h-u)/y,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=_e(this.x,t.x,e.x),this.y=_e(this.y,t.y,e.y),this.z=_e(this.z,t.z,e.z),this.w=_e(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=_e(this.x,t,e),this.y=_e(this.y,t,e),this.z=_e(this.z,t,e),this.w=_e(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_e(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};rf.prototype.isVector4=!0;var je=rf,Vl=class extends Li{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new je(0,0,t,e),this.scissorTest=!1,this.viewport=new je(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Kn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Jn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ao(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ui=class extends Vl{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},ra=class extends Kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Gl=class extends Kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var cc=class cc{constructor(t,e,i,s,r,o,a,l,c,u,f,h,d,g,v,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,f,h,d,g,v,m)}set(t,e,i,s,r,o,a,l,c,u,f,h,d,g,v,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=f,p[14]=h,p[3]=d,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new cc().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Wr.setFromMatrixColumn(t,0).length(),r=1/Wr.setFromMatrixColumn(t,1).length(),o=1/Wr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let h=o*u,d=o*f,g=a*u,v=a*f;e[0]=l*u,e[4]=-l*f,e[8]=c,e[1]=d+g*c,e[5]=h-v*c,e[9]=-a*l,e[2]=v-h*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*u,d=l*f,g=c*u,v=c*f;e[0]=h+v*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*f,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=v+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*u,d=l*f,g=c*u,v=c*f;e[0]=h-v*a,e[4]=-o*f,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=v-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*u,d=o*f,g=a*u,v=a*f;e[0]=l*u,e[4]=g*c-d,e[8]=h*c+v,e[1]=l*f,e[5]=v*c+h,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=v-h*f,e[8]=g*f+d,e[1]=f,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*f+g,e[10]=h-v*f}else if(t.order==="XZY"){let h=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=-f,e[8]=c*u,e[1]=h*f+v,e[5]=o*u,e[9]=d*f-g,e[2]=g*f-d,e[6]=a*u,e[10]=v*f+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(tx,t,ex)}lookAt(t,e,i){let s=this.elements;return ai.subVectors(t,e),ai.lengthSq()===0&&(ai.z=1),ai.normalize(),Us.crossVectors(i,ai),Us.lengthSq()===0&&(Math.abs(i.z)===1?ai.x+=1e-4:ai.z+=1e-4,ai.normalize(),Us.crossVectors(i,ai)),Us.normalize(),sl.crossVectors(ai,Us),s[0]=Us.x,s[4]=sl.x,s[8]=ai.x,s[1]=Us.y,s[5]=sl.y,s[9]=ai.y,s[2]=Us.z,s[6]=sl.z,s[10]=ai.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],g=i[2],v=i[6],m=i[10],p=i[14],y=i[3],A=i[7],M=i[11],R=i[15],E=s[0],_=s[4],T=s[8],V=s[12],F=s[1],L=s[5],D=s[9],G=s[13],P=s[2],W=s[6],O=s[10],N=s[14],J=s[3],X=s[7],Z=s[11],nt=s[15];return r[0]=o*E+a*F+l*P+c*J,r[4]=o*_+a*L+l*W+c*X,r[8]=o*T+a*D+l*O+c*Z,r[12]=o*V+a*G+l*N+c*nt,r[1]=u*E+f*F+h*P+d*J,r[5]=u*_+f*L+h*W+d*X,r[9]=u*T+f*D+h*O+d*Z,r[13]=u*V+f*G+h*N+d*nt,r[2]=g*E+v*F+m*P+p*J,r[6]=g*_+v*L+m*W+p*X,r[10]=g*T+v*D+m*O+p*Z,r[14]=g*V+v*G+m*N+p*nt,r[3]=y*E+A*F+M*P+R*J,r[7]=y*_+A*L+M*W+R*X,r[11]=y*T+A*D+M*O+R*Z,r[15]=y*V+A*G+M*N+R*nt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],f=t[6],h=t[10],d=t[14],g=t[3],v=t[7],m=t[11],p=t[15],y=l*d-c*h,A=a*d-c*f,M=a*h-l*f,R=o*d-c*u,E=o*h-l*u,_=o*f-a*u;return e*(v*y-m*A+p*M)-i*(g*y-m*R+p*E)+s*(g*A-v*R+p*_)-r*(g*M-v*E+m*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],f=t[9],h=t[10],d=t[11],g=t[12],v=t[13],m=t[14],p=t[15],y=e*a-i*o,A=e*l-s*o,M=e*c-r*o,R=i*l-s*a,E=i*c-r*a,_=s*c-r*l,T=u*v-f*g,V=u*m-h*g,F=u*p-d*g,L=f*m-h*v,D=f*p-d*v,G=h*p-d*m,P=y*G-A*D+M*L+R*F-E*V+_*T;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/P;return t[0]=(a*G-l*D+c*L)*W,t[1]=(s*D-i*G-r*L)*W,t[2]=(v*_-m*E+p*R)*W,t[3]=(h*E-f*_-d*R)*W,t[4]=(l*F-o*G-c*V)*W,t[5]=(e*G-s*F+r*V)*W,t[6]=(m*M-g*_-p*A)*W,t[7]=(u*_-h*M+d*A)*W,t[8]=(o*D-a*F+c*T)*W,t[9]=(i*F-e*D-r*T)*W,t[10]=(g*E-v*M+p*y)*W,t[11]=(f*M-u*E-d*y)*W,t[12]=(a*V-o*L-l*T)*W,t[13]=(e*L-i*V+s*T)*W,t[14]=(v*A-g*R-m*y)*W,t[15]=(u*R-f*A+h*y)*W,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,g=r*f,v=o*u,m=o*f,p=a*f,y=l*c,A=l*u,M=l*f,R=i.x,E=i.y,_=i.z;return s[0]=(1-(v+p))*R,s[1]=(d+M)*R,s[2]=(g-A)*R,s[3]=0,s[4]=(d-M)*E,s[5]=(1-(h+p))*E,s[6]=(m+y)*E,s[7]=0,s[8]=(g+A)*_,s[9]=(m-y)*_,s[10]=(1-(h+v))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Wr.set(s[0],s[1],s[2]).length(),a=Wr.set(s[4],s[5],s[6]).length(),l=Wr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ci.copy(this);let c=1/o,u=1/a,f=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=u,Ci.elements[5]*=u,Ci.elements[6]*=u,Ci.elements[8]*=f,Ci.elements[9]*=f,Ci.elements[10]*=f,e.setFromRotationMatrix(Ci),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=yi,l=!1){let c=this.elements,u=2*r/(e-t),f=2*r/(i-s),h=(e+t)/(e-t),d=(i+s)/(i-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===yi)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===so)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=yi,l=!1){let c=this.elements,u=2/(e-t),f=2/(i-s),h=-(e+t)/(e-t),d=-(i+s)/(i-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===yi)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===so)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}};cc.prototype.isMatrix4=!0;var ke=cc,Wr=new Y,Ci=new ke,tx=new Y(0,0,0),ex=new Y(1,1,1),Us=new Y,sl=new Y,ai=new Y,Vd=new ke,Gd=new zn,ys=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(_e(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_e(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(_e(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-_e(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(_e(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-_e(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:qt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Vd.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Vd,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Gd.setFromEuler(this),this.setFromQuaternion(Gd,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ys.DEFAULT_ORDER="XYZ";var lo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},nx=0,Hd=new Y,Xr=new zn,ds=new ke,rl=new Y,qo=new Y,ix=new Y,sx=new zn,Wd=new Y(1,0,0),Xd=new Y(0,1,0),$d=new Y(0,0,1),qd={type:"added"},rx={type:"removed"},$r={type:"childadded",child:null},Zh={type:"childremoved",child:null},Ln=class n extends Li{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:nx++}),this.uuid=So(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new Y,e=new ys,i=new zn,s=new Y(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ke},normalMatrix:{value:new ie}}),this.matrix=new ke,this.matrixWorld=new ke,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new lo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Xr.setFromAxisAngle(t,e),this.quaternion.multiply(Xr),this}rotateOnWorldAxis(t,e){return Xr.setFromAxisAngle(t,e),this.quaternion.premultiply(Xr),this}rotateX(t){return this.rotateOnAxis(Wd,t)}rotateY(t){return this.rotateOnAxis(Xd,t)}rotateZ(t){return this.rotateOnAxis($d,t)}translateOnAxis(t,e){return Hd.copy(t).applyQuaternion(this.quaternion),this.position.add(Hd.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Wd,t)}translateY(t){return this.translateOnAxis(Xd,t)}translateZ(t){return this.translateOnAxis($d,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ds.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?rl.copy(t):rl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),qo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ds.lookAt(qo,rl,this.up):ds.lookAt(rl,qo,this.up),this.quaternion.setFromRotationMatrix(ds),s&&(ds.extractRotation(s.matrixWorld),Xr.setFromRotationMatrix(ds),this.quaternion.premultiply(Xr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(te("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(qd),$r.child=t,this.dispatchEvent($r),$r.child=null):te("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(rx),Zh.child=t,this.dispatchEvent(Zh),Zh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ds.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ds.multiply(t.parent.matrixWorld)),t.applyMatrix4(ds),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(qd),$r.child=t,this.dispatchEvent($r),$r.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qo,t,ix),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qo,sx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(t.shapes,f)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),f=o(t.shapes),h=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ln.DEFAULT_UP=new Y(0,1,0);Ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ii=class extends Ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},ox={type:"move"},co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ii,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ii,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ii,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let v of t.hand.values()){let m=e.getJointPose(v,i),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,g=.005;c.inputState.pinching&&h>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ox)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ii;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Qp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Fs={h:0,s:0,l:0},ol={h:0,s:0,l:0};function Jh(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ce=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ci){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Se.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Se.workingColorSpace){return this.r=t,this.g=e,this.b=i,Se.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Se.workingColorSpace){if(t=qu(t,1),e=_e(e,0,1),i=_e(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Jh(o,r,t+1/3),this.g=Jh(o,r,t),this.b=Jh(o,r,t-1/3)}return Se.colorSpaceToWorking(this,s),this}setStyle(t,e=ci){function i(r){r!==void 0&&parseFloat(r)<1&&qt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:qt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);qt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ci){let i=Qp[t.toLowerCase()];return i!==void 0?this.setHex(i,e):qt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=xs(t.r),this.g=xs(t.g),this.b=xs(t.b),this}copyLinearToSRGB(t){return this.r=no(t.r),this.g=no(t.g),this.b=no(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ci){return Se.workingToColorSpace(kn.copy(this),t),Math.round(_e(kn.r*255,0,255))*65536+Math.round(_e(kn.g*255,0,255))*256+Math.round(_e(kn.b*255,0,255))}getHexString(t=ci){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Se.workingColorSpace){Se.workingToColorSpace(kn.copy(this),e);let i=kn.r,s=kn.g,r=kn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=Se.workingColorSpace){return Se.workingToColorSpace(kn.copy(this),e),t.r=kn.r,t.g=kn.g,t.b=kn.b,t}getStyle(t=ci){Se.workingToColorSpace(kn.copy(this),t);let e=kn.r,i=kn.g,s=kn.b;return t!==ci?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Fs),this.setHSL(Fs.h+t,Fs.s+e,Fs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Fs),t.getHSL(ol);let i=ta(Fs.h,ol.h,e),s=ta(Fs.s,ol.s,e),r=ta(Fs.l,ol.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new ce;ce.NAMES=Qp;var oa=class extends Ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ys,this.environmentIntensity=1,this.environmentRotation=new ys,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ri=new Y,ps=new Y,Kh=new Y,ms=new Y,qr=new Y,Yr=new Y,Yd=new Y,jh=new Y,Qh=new Y,tu=new Y,eu=new je,nu=new je,iu=new je,zs=class n{constructor(t=new Y,e=new Y,i=new Y){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ri.subVectors(t,e),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ri.subVectors(s,e),ps.subVectors(i,e),Kh.subVectors(t,e);let o=Ri.dot(Ri),a=Ri.dot(ps),l=Ri.dot(Kh),c=ps.dot(ps),u=ps.dot(Kh),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,g=(o*u-a*l)*h;return r.set(1-d-g,g,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ms)===null?!1:ms.x>=0&&ms.y>=0&&ms.x+ms.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ms.x),l.addScaledVector(o,ms.y),l.addScaledVector(a,ms.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return eu.setScalar(0),nu.setScalar(0),iu.setScalar(0),eu.fromBufferAttribute(t,e),nu.fromBufferAttribute(t,i),iu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(eu,r.x),o.addScaledVector(nu,r.y),o.addScaledVector(iu,r.z),o}static isFrontFacing(t,e,i,s){return Ri.subVectors(i,e),ps.subVectors(t,e),Ri.cross(ps).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ri.subVectors(this.c,this.b),ps.subVectors(this.a,this.b),Ri.cross(ps).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;qr.subVectors(s,i),Yr.subVectors(r,i),jh.subVectors(t,i);let l=qr.dot(jh),c=Yr.dot(jh);if(l<=0&&c<=0)return e.copy(i);Qh.subVectors(t,s);let u=qr.dot(Qh),f=Yr.dot(Qh);if(u>=0&&f<=u)return e.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(qr,o);tu.subVectors(t,r);let d=qr.dot(tu),g=Yr.dot(tu);if(g>=0&&d<=g)return e.copy(r);let v=d*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(Yr,a);let m=u*g-d*f;if(m<=0&&f-u>=0&&d-g>=0)return Yd.subVectors(r,s),a=(f-u)/(f-u+(d-g)),e.copy(s).addScaledVector(Yd,a);let p=1/(m+v+h);return o=v*p,a=h*p,e.copy(i).addScaledVector(qr,o).addScaledVector(Yr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Vs=class{constructor(t=new Y(1/0,1/0,1/0),e=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Pi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Pi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Pi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Pi):Pi.fromBufferAttribute(r,o),Pi.applyMatrix4(t.matrixWorld),this.expandByPoint(Pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),al.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),al.copy(i.boundingBox)),al.applyMatrix4(t.matrixWorld),this.union(al)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Pi),Pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Yo),ll.subVectors(this.max,Yo),Zr.subVectors(t.a,Yo),Jr.subVectors(t.b,Yo),Kr.subVectors(t.c,Yo),Os.subVectors(Jr,Zr),Bs.subVectors(Kr,Jr),fr.subVectors(Zr,Kr);let e=[0,-Os.z,Os.y,0,-Bs.z,Bs.y,0,-fr.z,fr.y,Os.z,0,-Os.x,Bs.z,0,-Bs.x,fr.z,0,-fr.x,-Os.y,Os.x,0,-Bs.y,Bs.x,0,-fr.y,fr.x,0];return!su(e,Zr,Jr,Kr,ll)||(e=[1,0,0,0,1,0,0,0,1],!su(e,Zr,Jr,Kr,ll))?!1:(cl.crossVectors(Os,Bs),e=[cl.x,cl.y,cl.z],su(e,Zr,Jr,Kr,ll))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(gs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),gs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),gs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),gs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),gs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),gs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),gs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),gs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(gs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},gs=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],Pi=new Y,al=new Vs,Zr=new Y,Jr=new Y,Kr=new Y,Os=new Y,Bs=new Y,fr=new Y,Yo=new Y,ll=new Y,cl=new Y,dr=new Y;function su(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){dr.fromArray(n,r);let a=s.x*Math.abs(dr.x)+s.y*Math.abs(dr.y)+s.z*Math.abs(dr.z),l=t.dot(dr),c=e.dot(dr),u=i.dot(dr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var mn=new Y,hl=new Jt,ax=0,Ji=class extends Li{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ax++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=$p,this.updateRanges=[],this.gpuType=Ni,this.version=0,this._normalizationScale=t!==void 0?Zu(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)hl.fromBufferAttribute(this,e),hl.applyMatrix3(t),this.setXY(e,hl.x,hl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Kp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):jp(t,this.array)}};var aa=class extends Ji{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var la=class extends Ji{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Oe=class extends Ji{constructor(t,e,i){super(new Float32Array(t),e,i)}},lx=new Vs,Zo=new Y,ru=new Y,Gs=class{constructor(t=new Y,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):lx.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Zo.subVectors(t,this.center);let e=Zo.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Zo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(ru.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Zo.copy(t.center).add(ru)),this.expandByPoint(Zo.copy(t.center).sub(ru))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},cx=0,vi=new ke,ou=new Ln,jr=new Y,li=new Vs,Jo=new Vs,Pn=new Y,vn=class n extends Li{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:cx++}),this.uuid=So(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(N_(t)?la:aa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ie().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return vi.makeRotationFromQuaternion(t),this.applyMatrix4(vi),this}rotateX(t){return vi.makeRotationX(t),this.applyMatrix4(vi),this}rotateY(t){return vi.makeRotationY(t),this.applyMatrix4(vi),this}rotateZ(t){return vi.makeRotationZ(t),this.applyMatrix4(vi),this}translate(t,e,i){return vi.makeTranslation(t,e,i),this.applyMatrix4(vi),this}scale(t,e,i){return vi.makeScale(t,e,i),this.applyMatrix4(vi),this}lookAt(t){return ou.lookAt(t),ou.updateMatrix(),this.applyMatrix4(ou.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jr).negate(),this.translate(jr.x,jr.y,jr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Oe(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&qt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Vs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];li.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,li.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,li.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(li.min),this.boundingBox.expandByPoint(li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&te('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Gs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(t){let i=this.boundingSphere.center;if(li.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Jo.setFromBufferAttribute(a),this.morphTargetsRelative?(Pn.addVectors(li.min,Jo.min),li.expandByPoint(Pn),Pn.addVectors(li.max,Jo.max),li.expandByPoint(Pn)):(li.expandByPoint(Jo.min),li.expandByPoint(Jo.max))}li.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Pn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Pn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Pn.fromBufferAttribute(a,c),l&&(jr.fromBufferAttribute(t,c),Pn.add(jr)),s=Math.max(s,i.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&te('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){te("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ji(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let V=0;V<i.count;V++)a[V]=new Y,l[V]=new Y;let u=new Y,f=new Y,h=new Y,d=new Jt,g=new Jt,v=new Jt,m=new Y,p=new Y;function y(V,F,L){c[V]=c[F]=c[L]=1,u.fromBufferAttribute(i,V),f.fromBufferAttribute(i,F),h.fromBufferAttribute(i,L),d.fromBufferAttribute(r,V),g.fromBufferAttribute(r,F),v.fromBufferAttribute(r,L),f.sub(u),h.sub(u),g.sub(d),v.sub(d);let D=1/(g.x*v.y-v.x*g.y);isFinite(D)&&(m.copy(f).multiplyScalar(v.y).addScaledVector(h,-g.y).multiplyScalar(D),p.copy(h).multiplyScalar(g.x).addScaledVector(f,-v.x).multiplyScalar(D),a[V].add(m),a[F].add(m),a[L].add(m),l[V].add(p),l[F].add(p),l[L].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let V=0,F=A.length;V<F;++V){let L=A[V],D=L.start,G=L.count;for(let P=D,W=D+G;P<W;P+=3)y(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let M=new Y,R=new Y,E=new Y,_=new Y;function T(V){E.fromBufferAttribute(s,V),_.copy(E);let F=a[V];M.copy(F),M.sub(E.multiplyScalar(E.dot(F))).normalize(),R.crossVectors(_,F);let D=R.dot(l[V])<0?-1:1;o.setXYZW(V,M.x,M.y,M.z,D)}for(let V=0,F=i.count;V<F;++V)c[V]&&T(V);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Ji(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new Y,r=new Y,o=new Y,a=new Y,l=new Y,c=new Y,u=new Y,f=new Y;if(t)for(let h=0,d=t.count;h<d;h+=3){let g=t.getX(h+0),v=t.getX(h+1),m=t.getX(h+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,d=e.count;h<d;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Pn.fromBufferAttribute(t,e),Pn.normalize(),t.setXYZ(e,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let p=0;p<u;p++)h[g++]=c[d++]}return new Ji(h,u,f)}if(this.index===null)return qt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=t(h,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var au=new Y,hx=new Y,ux=new ie,hi=class{constructor(t=new Y(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=au.subVectors(i,e).cross(hx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(au),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||ux.getNormalMatrix(t),s=this.coplanarPoint(au).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},fx=0,Ki=class extends Li{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:fx++}),this.uuid=So(),this.name="",this.type="Material",this.blending=xo,this.side=Ks,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Tu,this.blendDst=Eu,this.blendEquation=xr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ce(0,0,0),this.blendAlpha=0,this.depthFunc=io,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=zp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Rl,this.stencilZFail=Rl,this.stencilZPass=Rl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){qt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ce().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new hi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Jt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var _s=new Y,lu=new Y,ul=new Y,fl=new Y,Ss=class{constructor(t=new Y,e=new Y(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,_s)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=_s.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(_s.copy(this.origin).addScaledVector(this.direction,e),_s.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){lu.copy(t).add(e).multiplyScalar(.5),ul.copy(e).sub(t).normalize(),fl.copy(this.origin).sub(lu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(ul),a=fl.dot(this.direction),l=-fl.dot(ul),c=fl.lengthSq(),u=Math.abs(1-o*o),f,h,d,g;if(u>0)if(f=o*l-a,h=o*a-l,g=r*u,f>=0)if(h>=-g)if(h<=g){let v=1/u;f*=v,h*=v,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-g?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=g?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(lu).addScaledVector(ul,h),d}intersectSphere(t,e){if(t.radius<0)return null;_s.subVectors(t.center,this.origin);let i=_s.dot(this.direction),s=_s.dot(_s)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),u>=0?(r=(t.min.y-h.y)*u,o=(t.max.y-h.y)*u):(r=(t.max.y-h.y)*u,o=(t.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(t.min.z-h.z)*f,l=(t.max.z-h.z)*f):(a=(t.max.z-h.z)*f,l=(t.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,_s)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=t.x-o.x,h=t.y-o.y,d=t.z-o.z,g=e.x-o.x,v=e.y-o.y,m=e.z-o.z,p=i.x-o.x,y=i.y-o.y,A=i.z-o.z,M=Math.abs(l),R=Math.abs(c),E=Math.abs(u),_,T,V,F,L,D,G,P,W,O,N,J;if(M>=R&&M>=E?(V=l,D=f,W=g,J=p,l>=0?(_=c,T=u,F=h,L=d,G=v,P=m,O=y,N=A):(_=u,T=c,F=d,L=h,G=m,P=v,O=A,N=y)):R>=E?(V=c,D=h,W=v,J=y,c>=0?(_=u,T=l,F=d,L=f,G=m,P=g,O=A,N=p):(_=l,T=u,F=f,L=d,G=g,P=m,O=p,N=A)):(V=u,D=d,W=m,J=A,u>=0?(_=l,T=c,F=f,L=h,G=g,P=v,O=p,N=y):(_=c,T=l,F=h,L=f,G=v,P=g,O=y,N=p)),V===0)return null;let X=_/V,Z=T/V,nt=1/V,ft=F-X*D,ut=L-Z*D,et=G-X*W,mt=P-Z*W,xt=O-X*J,Ct=N-Z*J,Mt=xt*mt-Ct*et,Wt=ft*Ct-ut*xt,ae=et*ut-mt*ft;if(s){if(Mt<0||Wt<0||ae<0)return null}else if((Mt<0||Wt<0||ae<0)&&(Mt>0||Wt>0||ae>0))return null;let Gt=Mt+Wt+ae;if(Gt===0)return null;let pe=nt*(Mt*D+Wt*W+ae*J);return(Gt>0?pe<0:pe>0)?null:this.at(pe/Gt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Hl=class extends Ki{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ys,this.combine=hc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Zd=new ke,pr=new Ss,dl=new Gs,Jd=new Y,pl=new Y,ml=new Y,gl=new Y,cu=new Y,_l=new Y,Kd=new Y,xl=new Y,Si=class extends Ln{constructor(t=new vn,e=new Hl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){_l.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(cu.fromBufferAttribute(f,t),o?_l.addScaledVector(cu,u):_l.addScaledVector(cu.sub(e),u))}e.add(_l)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),dl.copy(i.boundingSphere),dl.applyMatrix4(r),pr.copy(t.ray).recast(t.near),!(dl.containsPoint(pr.origin)===!1&&(pr.intersectSphere(dl,Jd)===null||pr.origin.distanceToSquared(Jd)>(t.far-t.near)**2))&&(Zd.copy(r).invert(),pr.copy(t.ray).applyMatrix4(Zd),!(i.boundingBox!==null&&pr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,pr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=h.length;g<v;g++){let m=h[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),A=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let M=y,R=A;M<R;M+=3){let E=a.getX(M),_=a.getX(M+1),T=a.getX(M+2);s=vl(this,p,t,i,c,u,f,E,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){let y=a.getX(m),A=a.getX(m+1),M=a.getX(m+2);s=vl(this,o,t,i,c,u,f,y,A,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=h.length;g<v;g++){let m=h[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),A=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let M=y,R=A;M<R;M+=3){let E=M,_=M+1,T=M+2;s=vl(this,p,t,i,c,u,f,E,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){let y=m,A=m+1,M=m+2;s=vl(this,o,t,i,c,u,f,y,A,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function dx(n,t,e,i,s,r,o,a){let l;if(t.side===jn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ks,a),l===null)return null;xl.copy(a),xl.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(xl);return c<e.near||c>e.far?null:{distance:c,point:xl.clone(),object:n}}function vl(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,pl),n.getVertexPosition(l,ml),n.getVertexPosition(c,gl);let u=dx(n,t,e,i,pl,ml,gl,Kd);if(u){let f=new Y;zs.getBarycoord(Kd,pl,ml,gl,f),s&&(u.uv=zs.getInterpolatedAttribute(s,a,l,c,f,new Jt)),r&&(u.uv1=zs.getInterpolatedAttribute(r,a,l,c,f,new Jt)),o&&(u.normal=zs.getInterpolatedAttribute(o,a,l,c,f,new Y),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new Y,materialIndex:0};zs.getNormal(pl,ml,gl,h.normal),u.face=h,u.barycoord=f}return u}var Wl=class extends Kn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=In,u=In,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var mr=new Gs,px=new Jt(.5,.5),yl=new Y,Hs=class{constructor(t=new hi,e=new hi,i=new hi,s=new hi,r=new hi,o=new hi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=yi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],g=r[8],v=r[9],m=r[10],p=r[11],y=r[12],A=r[13],M=r[14],R=r[15];if(s[0].setComponents(c-o,d-u,p-g,R-y).normalize(),s[1].setComponents(c+o,d+u,p+g,R+y).normalize(),s[2].setComponents(c+a,d+f,p+v,R+A).normalize(),s[3].setComponents(c-a,d-f,p-v,R-A).normalize(),i)s[4].setComponents(l,h,m,M).normalize(),s[5].setComponents(c-l,d-h,p-m,R-M).normalize();else if(s[4].setComponents(c-l,d-h,p-m,R-M).normalize(),e===yi)s[5].setComponents(c+l,d+h,p+m,R+M).normalize();else if(e===so)s[5].setComponents(l,h,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),mr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),mr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(mr)}intersectsSprite(t){mr.center.set(0,0,0);let e=px.distanceTo(t.center);return mr.radius=.7071067811865476+e,mr.applyMatrix4(t.matrixWorld),this.intersectsSphere(mr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(yl.x=s.normal.x>0?t.max.x:t.min.x,yl.y=s.normal.y>0?t.max.y:t.min.y,yl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(yl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},jd=new ke,Xl=class n{constructor(){this.coordinateSystem=yi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];jd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Hs),i[s].setFromProjectionMatrix(jd,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Hs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var ji=class extends Ki{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ce(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},$l=new Y,ql=new Y,Qd=new ke,Ko=new Ss,Sl=new Gs,hu=new Y,tp=new Y,ho=class extends Ln{constructor(t=new vn,e=new ji){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)$l.fromBufferAttribute(e,s-1),ql.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=$l.distanceTo(ql);t.setAttribute("lineDistance",new Oe(i,1))}else qt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Sl.copy(i.boundingSphere),Sl.applyMatrix4(s),Sl.radius+=r,t.ray.intersectsSphere(Sl)===!1)return;Qd.copy(s).invert(),Ko.copy(t.ray).applyMatrix4(Qd);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){let p=u.getX(v),y=u.getX(v+1),A=Ml(this,t,Ko,l,p,y,v);A&&e.push(A)}if(this.isLineLoop){let v=u.getX(g-1),m=u.getX(d),p=Ml(this,t,Ko,l,v,m,g-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){let p=Ml(this,t,Ko,l,v,v+1,v);p&&e.push(p)}if(this.isLineLoop){let v=Ml(this,t,Ko,l,g-1,d,g-1);v&&e.push(v)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ml(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if($l.fromBufferAttribute(a,s),ql.fromBufferAttribute(a,r),e.distanceSqToSegment($l,ql,hu,tp)>i)return;hu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(hu);if(!(c<t.near||c>t.far))return{distance:c,point:tp.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var ep=new Y,np=new Y,Ws=class extends ho{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)ep.fromBufferAttribute(e,s),np.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+ep.distanceTo(np);t.setAttribute("lineDistance",new Oe(i,1))}else qt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var gr=class extends Ki{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ce(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},ip=new ke,gu=new Ss,bl=new Gs,wl=new Y,uo=class extends Ln{constructor(t=new vn,e=new gr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),bl.copy(i.boundingSphere),bl.applyMatrix4(s),bl.radius+=r,t.ray.intersectsSphere(bl)===!1)return;ip.copy(s).invert(),gu.copy(t.ray).applyMatrix4(ip);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,f=i.attributes.position;if(c!==null){let h=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=h,v=d;g<v;g++){let m=c.getX(g);wl.fromBufferAttribute(f,m),sp(wl,m,l,s,t,e,this)}}else{let h=Math.max(0,o.start),d=Math.min(f.count,o.start+o.count);for(let g=h,v=d;g<v;g++)wl.fromBufferAttribute(f,g),sp(wl,g,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function sp(n,t,e,i,s,r,o){let a=gu.distanceSqToPoint(n);if(a<e){let l=new Y;gu.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var ca=class extends Kn{constructor(t=[],e=vr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ha=class extends Kn{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ms=class extends Kn{constructor(t,e,i=Di,s,r,o,a=In,l=In,c,u=vs,f=1){if(u!==vs&&u!==ws)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ao(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ua=class extends Ms{constructor(t,e=Di,i=vr,s,r,o=In,a=In,l,c=vs){let u={width:t,height:t,depth:1},f=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},fa=class extends Kn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Xs=class n extends vn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Oe(c,3)),this.setAttribute("normal",new Oe(u,3)),this.setAttribute("uv",new Oe(f,2));function g(v,m,p,y,A,M,R,E,_,T,V){let F=M/_,L=R/T,D=M/2,G=R/2,P=E/2,W=_+1,O=T+1,N=0,J=0,X=new Y;for(let Z=0;Z<O;Z++){let nt=Z*L-G;for(let ft=0;ft<W;ft++){let ut=ft*F-D;X[v]=ut*y,X[m]=nt*A,X[p]=P,c.push(X.x,X.y,X.z),X[v]=0,X[m]=0,X[p]=E>0?1:-1,u.push(X.x,X.y,X.z),f.push(ft/_),f.push(1-Z/T),N+=1}}for(let Z=0;Z<T;Z++)for(let nt=0;nt<_;nt++){let ft=h+nt+W*Z,ut=h+nt+W*(Z+1),et=h+(nt+1)+W*(Z+1),mt=h+(nt+1)+W*Z;l.push(ft,ut,mt),l.push(ut,et,mt),J+=6}a.addGroup(d,J,V),d+=J,h+=N}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var fo=class n extends vn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],f=[],h=[],d=[],g=0,v=[],m=i/2,p=0;y(),o===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(u),this.setAttribute("position",new Oe(f,3)),this.setAttribute("normal",new Oe(h,3)),this.setAttribute("uv",new Oe(d,2));function y(){let M=new Y,R=new Y,E=0,_=(e-t)/i;for(let T=0;T<=r;T++){let V=[],F=T/r,L=F*(e-t)+t;for(let D=0;D<=s;D++){let G=D/s,P=G*l+a,W=Math.sin(P),O=Math.cos(P);R.x=L*W,R.y=-F*i+m,R.z=L*O,f.push(R.x,R.y,R.z),M.set(W,_,O).normalize(),h.push(M.x,M.y,M.z),d.push(G,1-F),V.push(g++)}v.push(V)}for(let T=0;T<s;T++)for(let V=0;V<r;V++){let F=v[V][T],L=v[V+1][T],D=v[V+1][T+1],G=v[V][T+1];(t>0||V!==0)&&(u.push(F,L,G),E+=3),(e>0||V!==r-1)&&(u.push(L,D,G),E+=3)}c.addGroup(p,E,0),p+=E}function A(M){let R=g,E=new Jt,_=new Y,T=0,V=M===!0?t:e,F=M===!0?1:-1;for(let D=1;D<=s;D++)f.push(0,m*F,0),h.push(0,F,0),d.push(.5,.5),g++;let L=g;for(let D=0;D<=s;D++){let P=D/s*l+a,W=Math.cos(P),O=Math.sin(P);_.x=V*O,_.y=m*F,_.z=V*W,f.push(_.x,_.y,_.z),h.push(0,F,0),E.x=W*.5+.5,E.y=O*.5*F+.5,d.push(E.x,E.y),g++}for(let D=0;D<s;D++){let G=R+D,P=L+D;M===!0?u.push(P,P+1,G):u.push(P+1,P,G),T+=3}c.addGroup(p,T,M===!0?1:2),p+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var da=class n extends vn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=t/a,h=e/l,d=[],g=[],v=[],m=[];for(let p=0;p<u;p++){let y=p*h-o;for(let A=0;A<c;A++){let M=A*f-r;g.push(M,-y,0),v.push(0,0,1),m.push(A/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){let A=y+c*p,M=y+c*(p+1),R=y+1+c*(p+1),E=y+1+c*p;d.push(A,M,E),d.push(M,R,E)}this.setIndex(d),this.setAttribute("position",new Oe(g,3)),this.setAttribute("normal",new Oe(v,3)),this.setAttribute("uv",new Oe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var pa=class n extends vn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],f=new Y,h=new Y,d=[],g=[],v=[],m=[];for(let p=0;p<=i;p++){let y=[],A=p/i,M=o+A*a,R=t*Math.cos(M),E=Math.sqrt(t*t-R*R),_=0;p===0&&o===0?_=.5/e:p===i&&l===Math.PI&&(_=-.5/e);for(let T=0;T<=e;T++){let V=T/e,F=s+V*r;f.x=-E*Math.cos(F),f.y=R,f.z=E*Math.sin(F),g.push(f.x,f.y,f.z),h.copy(f).normalize(),v.push(h.x,h.y,h.z),m.push(V+_,1-A),y.push(c++)}u.push(y)}for(let p=0;p<i;p++)for(let y=0;y<e;y++){let A=u[p][y+1],M=u[p][y],R=u[p+1][y],E=u[p+1][y+1];(p!==0||o>0)&&d.push(A,M,E),(p!==i-1||l<Math.PI)&&d.push(M,R,E)}this.setIndex(d),this.setAttribute("position",new Oe(g,3)),this.setAttribute("normal",new Oe(v,3)),this.setAttribute("uv",new Oe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function Sr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(rp(s))s.isRenderTargetTexture?(qt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(rp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Vn(n){let t={};for(let e=0;e<n.length;e++){let i=Sr(n[e]);for(let s in i)t[s]=i[s]}return t}function rp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function mx(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Ku(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Se.workingColorSpace}var tm={clone:Sr,merge:Vn},gx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,_x=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Qi=class extends Ki{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=gx,this.fragmentShader=_x,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Sr(t.uniforms),this.uniformsGroups=mx(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ce().setHex(s.value);break;case"v2":this.uniforms[i].value=new Jt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new Y().fromArray(s.value);break;case"v4":this.uniforms[i].value=new je().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ie().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ke().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Yl=class extends Qi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var po=class extends Ki{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ce(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Jc,this.normalScale=new Jt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ys,this.combine=hc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Zl=class extends Ki{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Bp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Jl=class extends Ki{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Qr(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Tl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var $s=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Kl=class extends $s{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:du,endingEnd:du}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case pu:r=t,a=2*e-i;break;case mu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case pu:o=t,l=2*i-e;break;case mu:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,g=(i-e)/(s-e),v=g*g,m=v*g,p=-h*m+2*h*v-h*g,y=(1+h)*m+(-1.5-2*h)*v+(-.5+h)*g+1,A=(-1-d)*m+(1.5+d)*v+.5*g,M=d*m-d*v;for(let R=0;R!==a;++R)r[R]=p*o[u+R]+y*o[c+R]+A*o[l+R]+M*o[f+R];return r}},jl=class extends $s{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},Ql=class extends $s{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},tc=class extends $s{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let g=(i-e)/(s-e),v=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*v+o[l+m]*g;return r}let h=a*2,d=t-1;for(let g=0;g!==a;++g){let v=o[c+g],m=o[l+g],p=d*h+g*2,y=f[p],A=f[p+1],M=t*h+g*2,R=u[M],E=u[M+1],_=vx(i,e,y,R,s);r[g]=em(_,v,A,E,m)}return r}};function em(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function xx(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function vx(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=em(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=xx(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var fi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Qr(e,this.TimeBufferType),this.values=Qr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Qr(t.times,Array),values:Qr(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Tl(t.settings)&&(i.settings={inTangents:Qr(t.settings.inTangents,Array),outTangents:Qr(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Ql(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new jl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Kl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new tc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ea:e=this.InterpolantFactoryMethodDiscrete;break;case kl:e=this.InterpolantFactoryMethodLinear;break;case Cl:e=this.InterpolantFactoryMethodSmooth;break;case fu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return qt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ea;case this.InterpolantFactoryMethodLinear:return kl;case this.InterpolantFactoryMethodSmooth:return Cl;case this.InterpolantFactoryMethodBezier:return fu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Tl(this.settings)&&(op(this.settings.inTangents,t),op(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Tl(this.settings)&&(ap(this.settings.inTangents,t),ap(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(te("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(te("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){te("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){te("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&U_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){te("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Cl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let g=0;g!==i;++g){let v=e[f+g];if(v!==e[h+g]||v!==e[d+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)e[h+d]=e[f+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Tl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function op(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function ap(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}fi.prototype.ValueTypeName="";fi.prototype.TimeBufferType=Float32Array;fi.prototype.ValueBufferType=Float32Array;fi.prototype.DefaultInterpolation=kl;var qs=class extends fi{constructor(t,e,i){super(t,e,i)}};qs.prototype.ValueTypeName="bool";qs.prototype.ValueBufferType=Array;qs.prototype.DefaultInterpolation=ea;qs.prototype.InterpolantFactoryMethodLinear=void 0;qs.prototype.InterpolantFactoryMethodSmooth=void 0;var ec=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}};ec.prototype.ValueTypeName="color";var nc=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}};nc.prototype.ValueTypeName="number";var ic=class extends $s{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)zn.slerpFlat(r,0,o,c-a,o,c,l);return r}},ma=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new ic(this.times,this.values,this.getValueSize(),t)}};ma.prototype.ValueTypeName="quaternion";ma.prototype.InterpolantFactoryMethodSmooth=void 0;var Ys=class extends fi{constructor(t,e,i){super(t,e,i)}};Ys.prototype.ValueTypeName="string";Ys.prototype.ValueBufferType=Array;Ys.prototype.DefaultInterpolation=ea;Ys.prototype.InterpolantFactoryMethodLinear=void 0;Ys.prototype.InterpolantFactoryMethodSmooth=void 0;var sc=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}};sc.prototype.ValueTypeName="vector";var rc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],g=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},nm=new rc,oc=class{constructor(t){this.manager=t!==void 0?t:nm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};oc.DEFAULT_MATERIAL_NAME="__DEFAULT";var ga=class extends Ln{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ce(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},_a=class extends ga{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ce(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},uu=new ke,lp=new Y,cp=new Y,ac=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Jt(512,512),this.mapType=ti,this.map=null,this.mapPass=null,this.matrix=new ke,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Hs,this._frameExtents=new Jt(1,1),this._viewportCount=1,this._viewports=[new je(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;lp.setFromMatrixPosition(t.matrixWorld),e.position.copy(lp),cp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(cp),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){uu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(uu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===so||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(uu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},El=new Y,Al=new zn,Yi=new Y,xa=class extends Ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ke,this.projectionMatrix=new ke,this.projectionMatrixInverse=new ke,this.coordinateSystem=yi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(El,Al,Yi),Yi.x===1&&Yi.y===1&&Yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(El,Al,Yi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(El,Al,Yi),Yi.x===1&&Yi.y===1&&Yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(El,Al,Yi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ks=new Y,hp=new Jt,up=new Jt,Zn=class extends xa{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=oo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Qo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return oo*2*Math.atan(Math.tan(Qo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){ks.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ks.x,ks.y).multiplyScalar(-t/ks.z),ks.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(ks.x,ks.y).multiplyScalar(-t/ks.z)}getViewSize(t,e){return this.getViewBounds(t,hp,up),e.subVectors(up,hp)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Qo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var va=class extends xa{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},_u=class extends ac{constructor(){super(new va(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ya=class extends ga{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.target=new Ln,this.shadow=new _u}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var to=-90,eo=1,mo=class extends Ln{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zn(to,eo,t,e);s.layers=this.layers,this.add(s);let r=new Zn(to,eo,t,e);r.layers=this.layers,this.add(r);let o=new Zn(to,eo,t,e);o.layers=this.layers,this.add(o);let a=new Zn(to,eo,t,e);a.layers=this.layers,this.add(a);let l=new Zn(to,eo,t,e);l.layers=this.layers,this.add(l);let c=new Zn(to,eo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===yi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===so)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=t.getRenderTarget(),h=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=v,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(f,h,d),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},lc=class extends Zn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var ju="\\[\\]\\.:\\/",yx=new RegExp("["+ju+"]","g"),Qu="[^"+ju+"]",Sx="[^"+ju.replace("\\.","")+"]",Mx=/((?:WC+[\/:])*)/.source.replace("WC",Qu),bx=/(WCOD+)?/.source.replace("WCOD",Sx),wx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Qu),Tx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Qu),Ex=new RegExp("^"+Mx+bx+wx+Tx+"$"),Ax=["material","materials","bones","map"],xu=class{constructor(t,e,i){let s=i||Ye.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ye=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(yx,"")}static parseTrackName(t){let e=Ex.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Ax.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){qt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){te("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){te("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){te("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){te("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){te("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;te("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ye.Composite=xu;Ye.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ye.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ye.prototype.GetterByBindingType=[Ye.prototype._getValue_direct,Ye.prototype._getValue_array,Ye.prototype._getValue_arrayElement,Ye.prototype._getValue_toArray];Ye.prototype.SetterByBindingTypeAndVersioning=[[Ye.prototype._setValue_direct,Ye.prototype._setValue_direct_setNeedsUpdate,Ye.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_array,Ye.prototype._setValue_array_setNeedsUpdate,Ye.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_arrayElement,Ye.prototype._setValue_arrayElement_setNeedsUpdate,Ye.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_fromArray,Ye.prototype._setValue_fromArray_setNeedsUpdate,Ye.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var qE=new Float32Array(1);var fp=new ke,Sa=class{constructor(t,e,i=0,s=1/0){this.ray=new Ss(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new lo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):te("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return fp.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(fp),this}intersectObject(t,e=!0,i=[]){return vu(t,this,i,e),i.sort(dp),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)vu(t[s],this,i,e);return i.sort(dp),i}};function dp(n,t){return n.distance-t.distance}function vu(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)vu(r[o],t,e,!0)}}var go=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=_e(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(_e(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var of=class of{constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};of.prototype.isMatrix2=!0;var yu=of;var Ma=class extends Ws{constructor(t=10,e=10,i=4473924,s=8947848){i=new ce(i),s=new ce(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let h=0,d=0,g=-a;h<=e;h++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let v=h===r?i:s;v.toArray(c,d),d+=3,v.toArray(c,d),d+=3,v.toArray(c,d),d+=3,v.toArray(c,d),d+=3}let u=new vn;u.setAttribute("position",new Oe(l,3)),u.setAttribute("color",new Oe(c,3));let f=new ji({vertexColors:!0,toneMapped:!1});super(u,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ba=class extends Li{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function tf(n,t,e,i){let s=Cx(i);switch(e){case ku:return n*t;case Vu:return n*t/s.components*s.byteLength;case _c:return n*t/s.components*s.byteLength;case js:return n*t*2/s.components*s.byteLength;case xc:return n*t*2/s.components*s.byteLength;case zu:return n*t*3/s.components*s.byteLength;case Fi:return n*t*4/s.components*s.byteLength;case vc:return n*t*4/s.components*s.byteLength;case Ea:case Aa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ca:case Ra:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Sc:case bc:return Math.max(n,16)*Math.max(t,8)/4;case yc:case Mc:return Math.max(n,8)*Math.max(t,8)/2;case wc:case Tc:case Ac:case Cc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ec:case Pa:case Rc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Pc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ic:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Lc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Dc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Nc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Uc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Fc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Oc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Bc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case kc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case zc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Vc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Gc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Hc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Wc:case Xc:case $c:return Math.ceil(n/4)*Math.ceil(t/4)*16;case qc:case Yc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Ia:case Zc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Cx(n){switch(n){case ti:case Uu:return{byteLength:1,components:1};case yo:case Fu:case Ui:return{byteLength:2,components:1};case mc:case gc:return{byteLength:2,components:4};case Di:case pc:case Ni:return{byteLength:4,components:1};case Ou:case Bu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function wm(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Px(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,g)=>d.start-g.start);let h=0;for(let d=1;d<f.length;d++){let g=f[h],v=f[d];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++h,f[h]=v)}f.length=h+1;for(let d=0,g=f.length;d<g;d++){let v=f[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Ix=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Lx=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Dx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Nx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ux=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Fx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ox=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Bx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kx=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,zx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Vx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Gx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Hx=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Wx=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Xx=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,$x=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,qx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Yx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Zx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Jx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Kx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,jx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Qx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,tv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,ev=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,nv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,iv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,sv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,rv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ov="gl_FragColor = linearToOutputTexel( gl_FragColor );",av=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,lv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,cv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,hv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,uv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,dv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,pv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,mv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,gv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_v=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,xv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,vv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,yv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Sv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Mv=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,bv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,wv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Tv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Ev=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Av=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Cv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Rv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Pv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Iv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Lv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Dv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Nv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Uv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Fv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ov=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Bv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,kv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,zv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Vv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Gv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Hv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Wv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Xv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$v=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,qv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Yv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Zv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Jv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Kv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,jv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Qv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,ty=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,ey=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,ny=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iy=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,sy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ry=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,oy=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,ay=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ly=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,cy=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,hy=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uy=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,fy=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,dy=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,py=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,my=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,gy=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_y=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,xy=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,vy=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,yy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Sy=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,My=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,by=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,wy=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Ty=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Ey=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Ay=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Cy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Ry=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Py=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Iy=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ly=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Dy=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ny=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Uy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Fy=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Oy=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,By=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,ky=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,zy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Vy=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Gy=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Hy=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Wy=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Xy=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$y=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,qy=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Yy=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Zy=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Jy=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Ky=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,jy=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Qy=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,tS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,eS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,nS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,iS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,rS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,oS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,aS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,lS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,cS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,de={alphahash_fragment:Ix,alphahash_pars_fragment:Lx,alphamap_fragment:Dx,alphamap_pars_fragment:Nx,alphatest_fragment:Ux,alphatest_pars_fragment:Fx,aomap_fragment:Ox,aomap_pars_fragment:Bx,batching_pars_vertex:kx,batching_vertex:zx,begin_vertex:Vx,beginnormal_vertex:Gx,bsdfs:Hx,iridescence_fragment:Wx,bumpmap_pars_fragment:Xx,clipping_planes_fragment:$x,clipping_planes_pars_fragment:qx,clipping_planes_pars_vertex:Yx,clipping_planes_vertex:Zx,color_fragment:Jx,color_pars_fragment:Kx,color_pars_vertex:jx,color_vertex:Qx,common:tv,defaultnormal_vertex:ev,displacementmap_pars_vertex:nv,displacementmap_vertex:iv,emissivemap_fragment:sv,emissivemap_pars_fragment:rv,colorspace_fragment:ov,colorspace_pars_fragment:av,envmap_fragment:lv,envmap_common_pars_fragment:cv,envmap_pars_fragment:hv,envmap_pars_vertex:uv,envmap_physical_pars_fragment:Mv,envmap_vertex:fv,fog_vertex:dv,fog_pars_vertex:pv,fog_fragment:mv,fog_pars_fragment:gv,gradientmap_pars_fragment:_v,lightmap_pars_fragment:xv,lights_lambert_fragment:vv,lights_lambert_pars_fragment:yv,lights_pars_begin:Sv,lights_toon_fragment:bv,lights_toon_pars_fragment:wv,lights_phong_fragment:Tv,lights_phong_pars_fragment:Ev,lights_physical_fragment:Av,lights_physical_pars_fragment:Cv,lights_fragment_begin:Rv,lights_fragment_maps:Pv,lights_fragment_end:Iv,lightprobes_pars_fragment:Lv,logdepthbuf_fragment:Dv,logdepthbuf_pars_fragment:Nv,logdepthbuf_pars_vertex:Uv,logdepthbuf_vertex:Fv,map_fragment:Ov,map_pars_fragment:Bv,map_particle_fragment:kv,map_particle_pars_fragment:zv,metalnessmap_fragment:Vv,metalnessmap_pars_fragment:Gv,morphinstance_vertex:Hv,morphcolor_vertex:Wv,morphnormal_vertex:Xv,morphtarget_pars_vertex:$v,morphtarget_vertex:qv,normal_fragment_begin:Yv,normal_fragment_maps:Zv,normal_pars_fragment:Jv,normal_pars_vertex:Kv,normal_vertex:jv,normalmap_pars_fragment:Qv,clearcoat_normal_fragment_begin:ty,clearcoat_normal_fragment_maps:ey,clearcoat_pars_fragment:ny,iridescence_pars_fragment:iy,opaque_fragment:sy,packing:ry,premultiplied_alpha_fragment:oy,project_vertex:ay,dithering_fragment:ly,dithering_pars_fragment:cy,roughnessmap_fragment:hy,roughnessmap_pars_fragment:uy,shadowmap_pars_fragment:fy,shadowmap_pars_vertex:dy,shadowmap_vertex:py,shadowmask_pars_fragment:my,skinbase_vertex:gy,skinning_pars_vertex:_y,skinning_vertex:xy,skinnormal_vertex:vy,specularmap_fragment:yy,specularmap_pars_fragment:Sy,tonemapping_fragment:My,tonemapping_pars_fragment:by,transmission_fragment:wy,transmission_pars_fragment:Ty,uv_pars_fragment:Ey,uv_pars_vertex:Ay,uv_vertex:Cy,worldpos_vertex:Ry,background_vert:Py,background_frag:Iy,backgroundCube_vert:Ly,backgroundCube_frag:Dy,cube_vert:Ny,cube_frag:Uy,depth_vert:Fy,depth_frag:Oy,distance_vert:By,distance_frag:ky,equirect_vert:zy,equirect_frag:Vy,linedashed_vert:Gy,linedashed_frag:Hy,meshbasic_vert:Wy,meshbasic_frag:Xy,meshlambert_vert:$y,meshlambert_frag:qy,meshmatcap_vert:Yy,meshmatcap_frag:Zy,meshnormal_vert:Jy,meshnormal_frag:Ky,meshphong_vert:jy,meshphong_frag:Qy,meshphysical_vert:tS,meshphysical_frag:eS,meshtoon_vert:nS,meshtoon_frag:iS,points_vert:sS,points_frag:rS,shadow_vert:oS,shadow_frag:aS,sprite_vert:lS,sprite_frag:cS},Dt={common:{diffuse:{value:new ce(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ie}},envmap:{envMap:{value:null},envMapRotation:{value:new ie},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ie}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ie}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ie},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ie},normalScale:{value:new Jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ie},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ie}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ie}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ie}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ce(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ce(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0},uvTransform:{value:new ie}},sprite:{diffuse:{value:new ce(16777215)},opacity:{value:1},center:{value:new Jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}}},is={basic:{uniforms:Vn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.fog]),vertexShader:de.meshbasic_vert,fragmentShader:de.meshbasic_frag},lambert:{uniforms:Vn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new ce(0)},envMapIntensity:{value:1}}]),vertexShader:de.meshlambert_vert,fragmentShader:de.meshlambert_frag},phong:{uniforms:Vn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new ce(0)},specular:{value:new ce(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:de.meshphong_vert,fragmentShader:de.meshphong_frag},standard:{uniforms:Vn([Dt.common,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.roughnessmap,Dt.metalnessmap,Dt.fog,Dt.lights,{emissive:{value:new ce(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag},toon:{uniforms:Vn([Dt.common,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.gradientmap,Dt.fog,Dt.lights,{emissive:{value:new ce(0)}}]),vertexShader:de.meshtoon_vert,fragmentShader:de.meshtoon_frag},matcap:{uniforms:Vn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,{matcap:{value:null}}]),vertexShader:de.meshmatcap_vert,fragmentShader:de.meshmatcap_frag},points:{uniforms:Vn([Dt.points,Dt.fog]),vertexShader:de.points_vert,fragmentShader:de.points_frag},dashed:{uniforms:Vn([Dt.common,Dt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:de.linedashed_vert,fragmentShader:de.linedashed_frag},depth:{uniforms:Vn([Dt.common,Dt.displacementmap]),vertexShader:de.depth_vert,fragmentShader:de.depth_frag},normal:{uniforms:Vn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,{opacity:{value:1}}]),vertexShader:de.meshnormal_vert,fragmentShader:de.meshnormal_frag},sprite:{uniforms:Vn([Dt.sprite,Dt.fog]),vertexShader:de.sprite_vert,fragmentShader:de.sprite_frag},background:{uniforms:{uvTransform:{value:new ie},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:de.background_vert,fragmentShader:de.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ie}},vertexShader:de.backgroundCube_vert,fragmentShader:de.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:de.cube_vert,fragmentShader:de.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:de.equirect_vert,fragmentShader:de.equirect_frag},distance:{uniforms:Vn([Dt.common,Dt.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:de.distance_vert,fragmentShader:de.distance_frag},shadow:{uniforms:Vn([Dt.lights,Dt.fog,{color:{value:new ce(0)},opacity:{value:1}}]),vertexShader:de.shadow_vert,fragmentShader:de.shadow_frag}};is.physical={uniforms:Vn([is.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ie},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ie},clearcoatNormalScale:{value:new Jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ie},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ie},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ie},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ie},sheen:{value:0},sheenColor:{value:new ce(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ie},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ie},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ie},transmissionSamplerSize:{value:new Jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ie},attenuationDistance:{value:0},attenuationColor:{value:new ce(0)},specularColor:{value:new ce(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ie},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ie},anisotropyVector:{value:new Jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ie}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag};var Kc={r:0,b:0,g:0},hS=new ke,Tm=new ie;Tm.set(-1,0,0,0,1,0,0,0,1);function uS(n,t,e,i,s,r){let o=new ce(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(y){let A=y.isScene===!0?y.background:null;if(A&&A.isTexture){let M=y.backgroundBlurriness>0;A=t.get(A,M)}return A}function g(y){let A=!1,M=d(y);M===null?m(o,a):M&&M.isColor&&(m(M,1),A=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(y,A){let M=d(A);M&&M.isCubeTexture?(c===void 0&&(c=new Si(new Xs(1,1,1),new Qi({name:"BackgroundCubeMaterial",uniforms:Sr(is.backgroundCube.uniforms),vertexShader:is.backgroundCube.vertexShader,fragmentShader:is.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(hS.makeRotationFromEuler(A.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Tm),c.material.toneMapped=Se.getTransfer(M.colorSpace)!==Pe,(u!==M||f!==M.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=M,f=M.version,h=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Si(new da(2,2),new Qi({name:"BackgroundMaterial",uniforms:Sr(is.background.uniforms),vertexShader:is.background.vertexShader,fragmentShader:is.background.fragmentShader,side:Ks,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=Se.getTransfer(M.colorSpace)!==Pe,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||f!==M.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=M,f=M.version,h=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,A){y.getRGB(Kc,Ku(n)),e.buffers.color.setClear(Kc.r,Kc.g,Kc.b,A,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,A=1){o.set(y),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:g,addToRenderList:v,dispose:p}}function fS(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,D,G,P,W){let O=!1,N=f(L,P,G,D);r!==N&&(r=N,c(r.object)),O=d(L,P,G,W),O&&g(L,P,G,W),W!==null&&t.update(W,n.ELEMENT_ARRAY_BUFFER),(O||o)&&(o=!1,M(L,D,G,P),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(W).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function f(L,D,G,P){let W=P.wireframe===!0,O=i[D.id];O===void 0&&(O={},i[D.id]=O);let N=L.isInstancedMesh===!0?L.id:0,J=O[N];J===void 0&&(J={},O[N]=J);let X=J[G.id];X===void 0&&(X={},J[G.id]=X);let Z=X[W];return Z===void 0&&(Z=h(l()),X[W]=Z),Z}function h(L){let D=[],G=[],P=[];for(let W=0;W<e;W++)D[W]=0,G[W]=0,P[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:G,attributeDivisors:P,object:L,attributes:{},index:null}}function d(L,D,G,P){let W=r.attributes,O=D.attributes,N=0,J=G.getAttributes();for(let X in J)if(J[X].location>=0){let nt=W[X],ft=O[X];if(ft===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(ft=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(ft=L.instanceColor)),nt===void 0||nt.attribute!==ft||ft&&nt.data!==ft.data)return!0;N++}return r.attributesNum!==N||r.index!==P}function g(L,D,G,P){let W={},O=D.attributes,N=0,J=G.getAttributes();for(let X in J)if(J[X].location>=0){let nt=O[X];nt===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(nt=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(nt=L.instanceColor));let ft={};ft.attribute=nt,nt&&nt.data&&(ft.data=nt.data),W[X]=ft,N++}r.attributes=W,r.attributesNum=N,r.index=P}function v(){let L=r.newAttributes;for(let D=0,G=L.length;D<G;D++)L[D]=0}function m(L){p(L,0)}function p(L,D){let G=r.newAttributes,P=r.enabledAttributes,W=r.attributeDivisors;G[L]=1,P[L]===0&&(n.enableVertexAttribArray(L),P[L]=1),W[L]!==D&&(n.vertexAttribDivisor(L,D),W[L]=D)}function y(){let L=r.newAttributes,D=r.enabledAttributes;for(let G=0,P=D.length;G<P;G++)D[G]!==L[G]&&(n.disableVertexAttribArray(G),D[G]=0)}function A(L,D,G,P,W,O,N){N===!0?n.vertexAttribIPointer(L,D,G,W,O):n.vertexAttribPointer(L,D,G,P,W,O)}function M(L,D,G,P){v();let W=P.attributes,O=G.getAttributes(),N=D.defaultAttributeValues;for(let J in O){let X=O[J];if(X.location>=0){let Z=W[J];if(Z===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(Z=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(Z=L.instanceColor)),Z!==void 0){let nt=Z.normalized,ft=Z.itemSize,ut=t.get(Z);if(ut===void 0)continue;let et=ut.buffer,mt=ut.type,xt=ut.bytesPerElement,Ct=mt===n.INT||mt===n.UNSIGNED_INT||Z.gpuType===pc;if(Z.isInterleavedBufferAttribute){let Mt=Z.data,Wt=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,ae=Z.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Gt=0;Gt<X.locationSize;Gt++)p(X.location+Gt,Mt.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Gt=0;Gt<X.locationSize;Gt++)m(X.location+Gt);n.bindBuffer(n.ARRAY_BUFFER,et);for(let Gt=0;Gt<X.locationSize;Gt++)A(X.location+Gt,ft/X.locationSize,mt,nt,Wt*xt,(ae+ft/X.locationSize*Gt)*xt,Ct)}else{if(Z.isInstancedBufferAttribute){for(let Mt=0;Mt<X.locationSize;Mt++)p(X.location+Mt,Z.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let Mt=0;Mt<X.locationSize;Mt++)m(X.location+Mt);n.bindBuffer(n.ARRAY_BUFFER,et);for(let Mt=0;Mt<X.locationSize;Mt++)A(X.location+Mt,ft/X.locationSize,mt,nt,ft*xt,ft/X.locationSize*Mt*xt,Ct)}}else if(N!==void 0){let nt=N[J];if(nt!==void 0)switch(nt.length){case 2:n.vertexAttrib2fv(X.location,nt);break;case 3:n.vertexAttrib3fv(X.location,nt);break;case 4:n.vertexAttrib4fv(X.location,nt);break;default:n.vertexAttrib1fv(X.location,nt)}}}}y()}function R(){V();for(let L in i){let D=i[L];for(let G in D){let P=D[G];for(let W in P){let O=P[W];for(let N in O)u(O[N].object),delete O[N];delete P[W]}}delete i[L]}}function E(L){if(i[L.id]===void 0)return;let D=i[L.id];for(let G in D){let P=D[G];for(let W in P){let O=P[W];for(let N in O)u(O[N].object),delete O[N];delete P[W]}}delete i[L.id]}function _(L){for(let D in i){let G=i[D];for(let P in G){let W=G[P];if(W[L.id]===void 0)continue;let O=W[L.id];for(let N in O)u(O[N].object),delete O[N];delete W[L.id]}}}function T(L){for(let D in i){let G=i[D],P=L.isInstancedMesh===!0?L.id:0,W=G[P];if(W!==void 0){for(let O in W){let N=W[O];for(let J in N)u(N[J].object),delete N[J];delete W[O]}delete G[P],Object.keys(G).length===0&&delete i[D]}}}function V(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:V,resetDefaultState:F,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:v,enableAttribute:m,disableUnusedAttributes:y}}function dS(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function pS(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Fi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===Ui&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ti&&_!==Ni&&!T&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(qt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&qt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&qt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:y,maxVaryings:A,maxFragmentUniforms:M,maxSamples:R,samples:E}}function mS(n){let t=this,e=null,i=0,s=!1,r=!1,o=new hi,a=new ie,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){e=u(f,h,0)},this.setState=function(f,h,d){let g=f.clippingPlanes,v=f.clipIntersection,m=f.clipShadows,p=n.get(f);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let y=r?0:i,A=y*4,M=p.clippingState||null;l.value=M,M=u(g,h,A,d);for(let R=0;R!==A;++R)M[R]=e[R];p.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(f,h,d,g){let v=f!==null?f.length:0,m=null;if(v!==0){if(m=l.value,g!==!0||m===null){let p=d+v*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<p)&&(m=new Float32Array(p));for(let A=0,M=d;A!==v;++A,M+=4)o.copy(f[A]).applyMatrix4(y,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}var Na=class extends ui{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ca(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Xs(5,5,5),r=new Qi({name:"CubemapFromEquirect",uniforms:Sr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:jn,blending:_r});r.uniforms.tEquirect.value=e;let o=new Si(s,r),a=e.minFilter;return e.minFilter===bs&&(e.minFilter=Jn),new mo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},im=256,gS=3,_S=20,Em=256,Am=16,xS=3,vS=new Y,yS=new ce,Qc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new mo(1,10,null),this._boxMesh=new Si(new Xs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=vS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,v=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(t.background=l.getClearColor(yS));let m=new mo(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=g,t.background=v,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=om(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=rm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(im,Yu(t))}_fromTexture(t,e){t.mapping===vr||t.mapping===vo?this._setSize(t.image.length===0?im:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=sm(t,!1,!1),i=Math.log2(t)-gS;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=sm(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===vr||t.mapping===vo?(this._cubemapMaterial===null&&(this._cubemapMaterial=om()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=rm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=SS(),this._integrationMaterial=MS());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Am);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-xS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Em*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=bS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function sm(n,t,e){return new Na(n,{minFilter:bs,generateMipmaps:t,type:Ui,colorSpace:na,depthBuffer:e})}function Ua(n,t,e){return new Qi({name:n,uniforms:t,vertexShader:de.cube_vert,fragmentShader:e,side:jn,blending:_r,depthTest:!1,depthWrite:!1})}function SS(){return Ua("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Em}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function MS(){return Ua("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Am}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function bS(){return Ua("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${_S}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function rm(){return Ua("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function om(){return Ua("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function wS(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===uc||d===fc)if(t.has(h)){let g=t.get(h).texture;return a(g,h.mapping)}else{let g=h.image;if(g&&g.height>0){let v=new Na(g.height);return v.fromEquirectangularTexture(n,h),t.set(h,v),h.addEventListener("dispose",c),a(v.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,g=d===uc||d===fc,v=d===vr||d===vo;if(g||v){let m=e.get(h),p=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==p)return i===null&&(i=new Qc(n)),m=g?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),m.texture;if(m!==void 0)return m.texture;{let y=h.image;return g&&y&&y.height>0||v&&y&&l(y)?(i===null&&(i=new Qc(n)),m=g?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function a(h,d){return d===uc?h.mapping=vr:d===fc&&(h.mapping=vo),h}function l(h){let d=0,g=6;for(let v=0;v<g;v++)h[v]!==void 0&&d++;return d===g}function c(h){let d=h.target;d.removeEventListener("dispose",c);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function f(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function TS(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&jo("WebGLRenderer: "+i+" extension not supported."),s}}}function ES(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let v=r.get(g);v&&(t.remove(v),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),e.memory.geometries++),v}function u(g){let v=g.attributes;for(let m in v)t.update(v[m],n.ARRAY_BUFFER)}function f(g){let v=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let y=v!==null?v.array.length:m.array.length/3-1,A=m.count>=65535?la:aa,M=new A(Math.ceil(y/3)*6,1),R=M.array;if(v!==null){let _=v.array;p=v.version;for(let T=0,V=0;T<y;T+=3){let F=_[T+0],L=_[T+1],D=_[T+2];R[V++]=F,R[V++]=L,R[V++]=L,R[V++]=D,R[V++]=D,R[V++]=F}}else{p=m.version;for(let _=0,T=0;_<y;_+=3){let V=_+0,F=_+1,L=_+2;R[T++]=V,R[T++]=F,R[T++]=F,R[T++]=L,R[T++]=L,R[T++]=V}}M.version=p;let E=r.get(g);E&&t.remove(E),r.set(g,M)}function h(g){let v=r.get(g);if(v){let m=g.index;m!==null&&v.version<m.version&&f(g)}else f(g);return r.get(g)}function d(){for(let g in s){let v=s[g].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function AS(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),e.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),e.update(h,i,d))}function u(f,h,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let v=0;for(let m=0;m<d;m++)v+=h[m];e.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function CS(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:te("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function RS(n,t,e){let i=new WeakMap,s=new je;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let V=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",V)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],A=0;d===!0&&(A=1),g===!0&&(A=2),v===!0&&(A=3);let M=a.attributes.position.count*A,R=1;M>t.maxTextureSize&&(R=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let E=new Float32Array(M*R*4*f),_=new ra(E,M,R,f);_.type=Ni,_.needsUpdate=!0;let T=A*4;for(let F=0;F<f;F++){let L=m[F],D=p[F],G=y[F],P=M*R*4*F;for(let W=0;W<L.count;W++){let O=W*T;d===!0&&(s.fromBufferAttribute(L,W),E[P+O+0]=s.x,E[P+O+1]=s.y,E[P+O+2]=s.z,E[P+O+3]=0),g===!0&&(s.fromBufferAttribute(D,W),E[P+O+4]=s.x,E[P+O+5]=s.y,E[P+O+6]=s.z,E[P+O+7]=0),v===!0&&(s.fromBufferAttribute(G,W),E[P+O+8]=s.x,E[P+O+9]=s.y,E[P+O+10]=s.z,E[P+O+11]=G.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new Jt(M,R)},i.set(a,h),a.addEventListener("dispose",V)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function PS(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=t.get(c,f);if(r.get(h)!==u&&(t.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var IS={[Au]:"LINEAR_TONE_MAPPING",[Cu]:"REINHARD_TONE_MAPPING",[Ru]:"CINEON_TONE_MAPPING",[Pu]:"ACES_FILMIC_TONE_MAPPING",[Lu]:"AGX_TONE_MAPPING",[Du]:"NEUTRAL_TONE_MAPPING",[Iu]:"CUSTOM_TONE_MAPPING"};function LS(n,t,e,i,s,r){let o=new ui(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new vn;u.setAttribute("position",new Oe([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Oe([0,2,0,0,2,0],2));let f=new Yl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new Si(u,f),d=new va(-1,1,1,-1,0,1),g=null,v=null,m=!1,p,y=null,A=[],M=!1;this.setSize=function(R,E){o.setSize(R,E),a!==null&&a.setSize(R,E),l!==null&&l.setSize(R,E);for(let _=0;_<A.length;_++){let T=A[_];T.setSize&&T.setSize(R,E)}},this.setEffects=function(R){A=R,M=A.length>0&&A[0].isRenderPass===!0;let E=o.width,_=o.height;A.length>0&&a===null&&(a=new ui(E,_,{type:Ui,depthBuffer:!1,stencilBuffer:!1}),l=new ui(E,_,{type:Ui,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(V=>V.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ms(E,_),r===!0&&(c.format=ws,c.type=yr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let V=0;V<A.length;V++){let F=A[V];F.setSize&&F.setSize(E,_),T&&F.needsDepthTexture===!0&&F.setDepthTexture&&F.setDepthTexture(c)}},this.begin=function(R,E){if(m||R.toneMapping===es&&A.length===0)return!1;if(y=E,E!==null){let _=E.width,T=E.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return M===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=es,!0},this.hasRenderPass=function(){return M},this.end=function(R,E){R.toneMapping=p,m=!0;let _=o,T=a;for(let V=0;V<A.length;V++){let F=A[V];F.enabled!==!1&&(F.render(R,T,_,E),F.needsSwap!==!1&&(_=T,T=T===a?l:a))}if(g!==R.outputColorSpace||v!==R.toneMapping){g=R.outputColorSpace,v=R.toneMapping,f.defines={},Se.getTransfer(g)===Pe&&(f.defines.SRGB_TRANSFER="");let V=IS[v];V&&(f.defines[V]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(y),R.render(h,d),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var Cm=new Kn,Rm=new Ms(1,1),Pm=new ua(1),Im=new ra,Lm=new Gl,Dm=new ca,am=[],lm=[],cm=new Float32Array(16),hm=new Float32Array(9),um=new Float32Array(4);function bo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=am[s];if(r===void 0&&(r=new Float32Array(s),am[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function yn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Sn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function eh(n,t){let e=lm[t];e===void 0&&(e=new Int32Array(t),lm[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function DS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function NS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2fv(this.addr,t),Sn(e,t)}}function US(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(yn(e,t))return;n.uniform3fv(this.addr,t),Sn(e,t)}}function FS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4fv(this.addr,t),Sn(e,t)}}function OS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Sn(e,t)}else{if(yn(e,i))return;um.set(i),n.uniformMatrix2fv(this.addr,!1,um),Sn(e,i)}}function BS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Sn(e,t)}else{if(yn(e,i))return;hm.set(i),n.uniformMatrix3fv(this.addr,!1,hm),Sn(e,i)}}function kS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Sn(e,t)}else{if(yn(e,i))return;cm.set(i),n.uniformMatrix4fv(this.addr,!1,cm),Sn(e,i)}}function zS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function VS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2iv(this.addr,t),Sn(e,t)}}function GS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;n.uniform3iv(this.addr,t),Sn(e,t)}}function HS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4iv(this.addr,t),Sn(e,t)}}function WS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function XS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2uiv(this.addr,t),Sn(e,t)}}function $S(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;n.uniform3uiv(this.addr,t),Sn(e,t)}}function qS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4uiv(this.addr,t),Sn(e,t)}}function nh(n){return n.version===0&&(n.compareFunction=Wu,n.needsUpdate=!0),n}function YS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=nh(Rm):r=Cm,e.setTexture2D(t||r,s)}function ZS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Lm,s)}function JS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=nh(Pm):r=Dm,e.setTextureCube(t||r,s)}function KS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Im,s)}function jS(n){switch(n){case 5126:return DS;case 35664:return NS;case 35665:return US;case 35666:return FS;case 35674:return OS;case 35675:return BS;case 35676:return kS;case 5124:case 35670:return zS;case 35667:case 35671:return VS;case 35668:case 35672:return GS;case 35669:case 35673:return HS;case 5125:return WS;case 36294:return XS;case 36295:return $S;case 36296:return qS;case 35678:case 36198:case 36298:case 36306:case 35682:return YS;case 35679:case 36299:case 36307:return ZS;case 35680:case 36300:case 36308:case 36293:return JS;case 36289:case 36303:case 36311:case 36292:return KS}}function QS(n,t){n.uniform1fv(this.addr,t)}function tM(n,t){let e=bo(t,this.size,2);n.uniform2fv(this.addr,e)}function eM(n,t){let e=bo(t,this.size,3);n.uniform3fv(this.addr,e)}function nM(n,t){let e=bo(t,this.size,4);n.uniform4fv(this.addr,e)}function iM(n,t){let e=bo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function sM(n,t){let e=bo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function rM(n,t){let e=bo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function oM(n,t){n.uniform1iv(this.addr,t)}function aM(n,t){n.uniform2iv(this.addr,t)}function lM(n,t){n.uniform3iv(this.addr,t)}function cM(n,t){n.uniform4iv(this.addr,t)}function hM(n,t){n.uniform1uiv(this.addr,t)}function uM(n,t){n.uniform2uiv(this.addr,t)}function fM(n,t){n.uniform3uiv(this.addr,t)}function dM(n,t){n.uniform4uiv(this.addr,t)}function pM(n,t,e){let i=this.cache,s=t.length,r=eh(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=nh(Rm):o=Cm;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function mM(n,t,e){let i=this.cache,s=t.length,r=eh(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Lm,r[o])}function gM(n,t,e){let i=this.cache,s=t.length,r=eh(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=nh(Pm):o=Dm;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function _M(n,t,e){let i=this.cache,s=t.length,r=eh(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Im,r[o])}function xM(n){switch(n){case 5126:return QS;case 35664:return tM;case 35665:return eM;case 35666:return nM;case 35674:return iM;case 35675:return sM;case 35676:return rM;case 5124:case 35670:return oM;case 35667:case 35671:return aM;case 35668:case 35672:return lM;case 35669:case 35673:return cM;case 5125:return hM;case 36294:return uM;case 36295:return fM;case 36296:return dM;case 35678:case 36198:case 36298:case 36306:case 35682:return pM;case 35679:case 36299:case 36307:return mM;case 35680:case 36300:case 36308:case 36293:return gM;case 36289:case 36303:case 36311:case 36292:return _M}}var cf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=jS(e.type)}},hf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=xM(e.type)}},uf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},af=/(\w+)(\])?(\[|\.)?/g;function fm(n,t){n.seq.push(t),n.map[t.id]=t}function vM(n,t,e){let i=n.name,s=i.length;for(af.lastIndex=0;;){let r=af.exec(i),o=af.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){fm(e,c===void 0?new cf(a,n,t):new hf(a,n,t));break}else{let f=e.map[a];f===void 0&&(f=new uf(a),fm(e,f)),e=f}}}var Mo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);vM(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function dm(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var yM=37297,SM=0;function MM(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var pm=new ie;function bM(n){Se._getMatrix(pm,Se.workingColorSpace,n);let t=`mat3( ${pm.elements.map(e=>e.toFixed(4))} )`;switch(Se.getTransfer(n)){case ia:return[t,"LinearTransferOETF"];case Pe:return[t,"sRGBTransferOETF"];default:return qt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function mm(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+MM(n.getShaderSource(t),a)}else return r}function wM(n,t){let e=bM(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var TM={[Au]:"Linear",[Cu]:"Reinhard",[Ru]:"Cineon",[Pu]:"ACESFilmic",[Lu]:"AgX",[Du]:"Neutral",[Iu]:"Custom"};function EM(n,t){let e=TM[t];return e===void 0?(qt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var jc=new Y;function AM(){Se.getLuminanceCoefficients(jc);let n=jc.x.toFixed(4),t=jc.y.toFixed(4),e=jc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function CM(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Da).join(`
`)}function RM(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function PM(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Da(n){return n!==""}function gm(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function _m(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var IM=/^[ \t]*#include +<([\w\d./]+)>/gm;function ff(n){return n.replace(IM,LM)}function LM(n,t){let e=de[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return ff(e)}var DM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function xm(n){return n.replace(DM,NM)}function NM(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function vm(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var UM={[wa]:"SHADOWMAP_TYPE_PCF",[_o]:"SHADOWMAP_TYPE_VSM"};function FM(n){return UM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var OM={[vo]:"ENVMAP_MODE_REFRACTION"};function BM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":OM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var kM={[hc]:"ENVMAP_BLENDING_MULTIPLY",[Up]:"ENVMAP_BLENDING_MIX",[Fp]:"ENVMAP_BLENDING_ADD"};function zM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":kM[n.combine]||"ENVMAP_BLENDING_NONE"}function VM(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=FM(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=BM(e),f=zM(e),h=CM(e),d=RM(r),g=s.createProgram(),v,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(v=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Da).join(`
`),v.length>0&&(v+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Da).join(`
`),m.length>0&&(m+=`
`)):(v=[vm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Da).join(`
`),m=[vm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==es?"#define TONE_MAPPING":"",e.toneMapping!==es?de.tonemapping_pars_fragment:"",e.toneMapping!==es?EM("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",de.colorspace_pars_fragment,wM("linearToOutputTexel",e.outputColorSpace),AM(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Da).join(`
`)),o=ff(o),o=gm(o,e),o=_m(o,e),a=ff(a),a=gm(a,e),a=_m(a,e),o=xm(o),a=xm(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,v=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,m=["#define varying in",e.glslVersion===Xu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Xu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=p+v+o,A=p+m+a,M=dm(s,s.VERTEX_SHADER,y),R=dm(s,s.FRAGMENT_SHADER,A);s.attachShader(g,M),s.attachShader(g,R),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(F){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(g)||"",D=s.getShaderInfoLog(M)||"",G=s.getShaderInfoLog(R)||"",P=L.trim(),W=D.trim(),O=G.trim(),N=!0,J=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(N=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,M,R);else{let X=mm(s,M,"vertex"),Z=mm(s,R,"fragment");te("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+F.name+`
Material Type: `+F.type+`

Program Info Log: `+P+`
`+X+`
`+Z)}else P!==""?qt("WebGLProgram: Program Info Log:",P):(W===""||O==="")&&(J=!1);J&&(F.diagnostics={runnable:N,programLog:P,vertexShader:{log:W,prefix:v},fragmentShader:{log:O,prefix:m}})}s.deleteShader(M),s.deleteShader(R),_=new Mo(s,g),T=PM(s,g)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let V=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return V===!1&&(V=s.getProgramParameter(g,yM)),V},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=SM++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=M,this.fragmentShader=R,this}var GM=0,df=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new pf(t),e.set(t,i)),i}},pf=class{constructor(t){this.id=GM++,this.code=t,this.usedTimes=0}};function HM(n){return n===js||n===Pa||n===Ia}function WM(n,t,e,i,s,r){let o=new lo,a=new df,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,T,V,F,L,D){let G=F.fog,P=L.geometry,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?F.environment:null,O=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,N=t.get(_.envMap||W,O),J=h[_.type],X=i.precision;_.precision!==null&&(X=i.getMaxPrecision(_.precision),X!==_.precision&&qt("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let Z=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,nt=Z!==void 0?Z.length:0,ft=0;P.morphAttributes.position!==void 0&&(ft=1),P.morphAttributes.normal!==void 0&&(ft=2),P.morphAttributes.color!==void 0&&(ft=3);let ut,et,mt,xt;if(J){let Rt=is[J];ut=Rt.vertexShader,et=Rt.fragmentShader}else{ut=_.vertexShader,et=_.fragmentShader;let Rt=a.getVertexShaderStage(_),he=a.getFragmentShaderStage(_);a.update(_,Rt,he),mt=Rt.id,xt=he.id}let Ct=n.getRenderTarget(),Mt=n.state.buffers.depth.getReversed(),Wt=L.isInstancedMesh===!0,ae=L.isBatchedMesh===!0,Gt=!!_.map,pe=!!_.matcap,ue=!!N,re=ue&&N.isPMREMTexture===!0,Je=!!_.aoMap,He=!!_.lightMap,cn=!!_.bumpMap&&_.wireframe===!1,Ue=!!_.normalMap,Tn=!!_.displacementMap,be=!!_.emissiveMap,_n=!!_.metalnessMap,en=!!_.roughnessMap,hn=_.anisotropy>0,z=_.clearcoat>0,Pt=_.diffuseRoughness>0,Yt=_.dispersion>0,le=_.retroreflectivity>0,bt=_.iridescence>0,Be=_.sheen>0,Vt=_.transmission>0,$t=hn&&!!_.anisotropyMap,C=z&&!!_.clearcoatMap,S=z&&!!_.clearcoatNormalMap,q=z&&!!_.clearcoatRoughnessMap,ht=Pt&&!!_.diffuseRoughnessMap,at=bt&&!!_.iridescenceMap,_t=bt&&!!_.iridescenceThicknessMap,vt=Be&&!!_.sheenColorMap,it=Be&&!!_.sheenRoughnessMap,rt=!!_.specularMap,pt=!!_.specularColorMap,B=!!_.specularIntensityMap,ot=Vt&&!!_.transmissionMap,st=Vt&&!!_.thicknessMap,wt=!!_.gradientMap,gt=!!_.alphaMap,St=_.alphaTest>0,Ht=!!_.alphaHash,jt=!!_.extensions,ct=es;_.toneMapped&&(Ct===null||Ct.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Bt=re?N.isCompressedCubeTexture?N.image[0].mipmaps:N.mipmaps:null,Qt={shaderID:J,shaderType:_.type,shaderName:_.name,vertexShader:ut,fragmentShader:et,defines:_.defines,customVertexShaderID:mt,customFragmentShaderID:xt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:ae,batchingColor:ae&&L._colorsTexture!==null,instancing:Wt,instancingColor:Wt&&L.instanceColor!==null,instancingMorph:Wt&&L.morphTexture!==null,outputColorSpace:Ct===null?n.outputColorSpace:Ct.isXRRenderTarget===!0?Ct.texture.colorSpace:Se.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Gt,matcap:pe,envMap:ue,envMapMode:ue&&N.mapping,envMapPMREM:re,envMapMaxLod:re?Bt.length-1:null,envMapSize:re?Bt[0].width:null,aoMap:Je,lightMap:He,bumpMap:cn,normalMap:Ue,displacementMap:Tn,emissiveMap:be,normalMapObjectSpace:Ue&&_.normalMapType===kp,normalMapTangentSpace:Ue&&_.normalMapType===Jc,packedNormalMap:Ue&&_.normalMapType===Jc&&HM(_.normalMap.format),metalnessMap:_n,roughnessMap:en,anisotropy:hn,anisotropyMap:$t,clearcoat:z,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Pt,diffuseRoughnessMap:ht,dispersion:Yt,retroreflection:le,iridescence:bt,iridescenceMap:at,iridescenceThicknessMap:_t,sheen:Be,sheenColorMap:vt,sheenRoughnessMap:it,specularMap:rt,specularColorMap:pt,specularIntensityMap:B,transmission:Vt,transmissionMap:ot,thicknessMap:st,gradientMap:wt,opaque:_.transparent===!1&&_.blending===xo&&_.alphaToCoverage===!1,alphaMap:gt,alphaTest:St,alphaHash:Ht,combine:_.combine,mapUv:Gt&&d(_.map.channel),aoMapUv:Je&&d(_.aoMap.channel),lightMapUv:He&&d(_.lightMap.channel),bumpMapUv:cn&&d(_.bumpMap.channel),normalMapUv:Ue&&d(_.normalMap.channel),displacementMapUv:Tn&&d(_.displacementMap.channel),emissiveMapUv:be&&d(_.emissiveMap.channel),metalnessMapUv:_n&&d(_.metalnessMap.channel),roughnessMapUv:en&&d(_.roughnessMap.channel),anisotropyMapUv:$t&&d(_.anisotropyMap.channel),clearcoatMapUv:C&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:it&&d(_.sheenRoughnessMap.channel),specularMapUv:rt&&d(_.specularMap.channel),specularColorMapUv:pt&&d(_.specularColorMap.channel),specularIntensityMapUv:B&&d(_.specularIntensityMap.channel),transmissionMapUv:ot&&d(_.transmissionMap.channel),thicknessMapUv:st&&d(_.thicknessMap.channel),alphaMapUv:gt&&d(_.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Ue||hn),vertexNormals:!!P.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!P.attributes.uv&&(Gt||gt),fog:!!G,useFog:_.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||P.attributes.normal===void 0&&Ue===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:Mt,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:nt,morphTextureStride:ft,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:D.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&V.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Gt&&_.map.isVideoTexture===!0&&Se.getTransfer(_.map.colorSpace)===Pe,decodeVideoTextureEmissive:be&&_.emissiveMap.isVideoTexture===!0&&Se.getTransfer(_.emissiveMap.colorSpace)===Pe,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ts,flipSided:_.side===jn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:jt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(jt&&_.extensions.multiDraw===!0||ae)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Qt.vertexUv1s=l.has(1),Qt.vertexUv2s=l.has(2),Qt.vertexUv3s=l.has(3),l.clear(),Qt}function v(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let V in _.defines)T.push(V),T.push(_.defines[V]);return _.isRawShaderMaterial===!1&&(m(T,_),p(T,_),T.push(n.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function m(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function p(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let T=h[_.type],V;if(T){let F=is[T];V=tm.clone(F.uniforms)}else V=_.uniforms;return V}function A(_,T){let V=u.get(T);return V!==void 0?++V.usedTimes:(V=new VM(n,T,_,s),c.push(V),u.set(T,V)),V}function M(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:v,getUniforms:y,acquireProgram:A,releaseProgram:M,releaseShaderCache:R,programs:c,dispose:E}}function XM(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function $M(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function ym(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Sm(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,g,v,m,p){let y=n[t];return y===void 0?(y={id:h.id,object:h,geometry:d,material:g,materialVariant:o(h),groupOrder:v,renderOrder:h.renderOrder,z:m,group:p},n[t]=y):(y.id=h.id,y.object=h,y.geometry=d,y.material=g,y.materialVariant=o(h),y.groupOrder=v,y.renderOrder=h.renderOrder,y.z=m,y.group=p),t++,y}function l(h,d,g,v,m,p,y){y.reversedDepth===!0&&(m=-m);let A=a(h,d,g,v,m,p);g.transmission>0?i.push(A):g.transparent===!0?s.push(A):e.push(A)}function c(h,d,g,v,m,p){let y=a(h,d,g,v,m,p);g.transmission>0?i.unshift(y):g.transparent===!0?s.unshift(y):e.unshift(y)}function u(h,d){e.length>1&&e.sort(h||$M),i.length>1&&i.sort(d||ym),s.length>1&&s.sort(d||ym)}function f(){for(let h=t,d=n.length;h<d;h++){let g=n[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function qM(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Sm,n.set(i,[o])):s>=r.length?(o=new Sm,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function YM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new Y,color:new ce};break;case"SpotLight":e={position:new Y,direction:new Y,color:new ce,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new Y,color:new ce,distance:0,decay:0};break;case"HemisphereLight":e={direction:new Y,skyColor:new ce,groundColor:new ce};break;case"RectAreaLight":e={color:new ce,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return n[t.id]=e,e}}}function ZM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var JM=0;function KM(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function jM(n){let t=new YM,e=ZM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Y);let s=new Y,r=new ke,o=new ke;function a(c){let u=0,f=0,h=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let d=0,g=0,v=0,m=0,p=0,y=0,A=0,M=0,R=0,E=0,_=0,T=0,V=0,F=0;c.sort(KM);for(let D=0,G=c.length;D<G;D++){let P=c[D],W=P.color,O=P.intensity,N=P.distance,J=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===js?J=P.shadow.map.texture:J=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=W.r*O,f+=W.g*O,h+=W.b*O;else if(P.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(P.sh.coefficients[X],O);F++}else if(P.isSunLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Z=P.shadow,nt=e.get(P);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[g]=nt,i.sunShadowMap[g]=J;let ft=Z.getViewportCount();for(let ut=0;ut<ft;ut++)i.sunShadowMatrix[v+ut]=Z.getMatrix(ut),i.sunShadowCascade[v+ut]=Z._cascadeData[ut];v+=ft,g++}i.sun[d]=X,d++}else if(P.isDirectionalLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Z=P.shadow,nt=e.get(P);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,i.directionalShadow[m]=nt,i.directionalShadowMap[m]=J,i.directionalShadowMatrix[m]=P.shadow.matrix,R++}i.directional[m]=X,m++}else if(P.isSpotLight){let X=t.get(P);X.position.setFromMatrixPosition(P.matrixWorld),X.color.copy(W).multiplyScalar(O),X.distance=N,X.coneCos=Math.cos(P.angle),X.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),X.decay=P.decay,i.spot[y]=X;let Z=P.shadow;if(P.map&&(i.spotLightMap[T]=P.map,T++,Z.updateMatrices(P),P.castShadow&&V++),i.spotLightMatrix[y]=Z.matrix,P.castShadow){let nt=e.get(P);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,i.spotShadow[y]=nt,i.spotShadowMap[y]=J,_++}y++}else if(P.isRectAreaLight){let X=t.get(P);X.color.copy(W).multiplyScalar(O),X.halfWidth.set(P.width*.5,0,0),X.halfHeight.set(0,P.height*.5,0),i.rectArea[A]=X,A++}else if(P.isPointLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),X.distance=P.distance,X.decay=P.decay,P.castShadow){let Z=P.shadow,nt=e.get(P);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,nt.shadowCameraNear=Z.camera.near,nt.shadowCameraFar=Z.camera.far,i.pointShadow[p]=nt,i.pointShadowMap[p]=J,i.pointShadowMatrix[p]=P.shadow.matrix,E++}i.point[p]=X,p++}else if(P.isHemisphereLight){let X=t.get(P);X.skyColor.copy(P.color).multiplyScalar(O),X.groundColor.copy(P.groundColor).multiplyScalar(O),i.hemi[M]=X,M++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Dt.LTC_FLOAT_1,i.rectAreaLTC2=Dt.LTC_FLOAT_2):(i.rectAreaLTC1=Dt.LTC_HALF_1,i.rectAreaLTC2=Dt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let L=i.hash;(L.sunLength!==d||L.directionalLength!==m||L.pointLength!==p||L.spotLength!==y||L.rectAreaLength!==A||L.hemiLength!==M||L.numSunShadows!==g||L.numDirectionalShadows!==R||L.numPointShadows!==E||L.numSpotShadows!==_||L.numSpotMaps!==T||L.numLightProbes!==F)&&(i.sun.length=d,i.directional.length=m,i.spot.length=y,i.rectArea.length=A,i.point.length=p,i.hemi.length=M,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+T-V,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=V,i.numLightProbes=F,L.sunLength=d,L.directionalLength=m,L.pointLength=p,L.spotLength=y,L.rectAreaLength=A,L.hemiLength=M,L.numSunShadows=g,L.numDirectionalShadows=R,L.numPointShadows=E,L.numSpotShadows=_,L.numSpotMaps=T,L.numLightProbes=F,i.version=JM++)}function l(c,u){let f=0,h=0,d=0,g=0,v=0,m=0,p=u.matrixWorldInverse;for(let y=0,A=c.length;y<A;y++){let M=c[y];if(M.isSunLight){let R=i.sun[f];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),f++}else if(M.isDirectionalLight){let R=i.directional[h];R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),h++}else if(M.isSpotLight){let R=i.spot[g];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),g++}else if(M.isRectAreaLight){let R=i.rectArea[v];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(M.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(M.width*.5,0,0),R.halfHeight.set(0,M.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),v++}else if(M.isPointLight){let R=i.point[d];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),d++}else if(M.isHemisphereLight){let R=i.hemi[m];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:i}}function Mm(n){let t=new jM(n),e=[],i=[],s=[];function r(f){u.camera=f,e.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):e.push(f)}function a(f){i.push(f)}function l(){t.setup(e),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){t.setupView(e,f)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function QM(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Mm(n),t.set(s,[a])):r>=o.length?(a=new Mm(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var tb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,eb=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,nb=[new Y(1,0,0),new Y(-1,0,0),new Y(0,1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1)],ib=[new Y(0,-1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1),new Y(0,-1,0),new Y(0,-1,0)],bm=new ke,La=new Y,lf=new Y;function sb(n,t,e){let i=new Hs,s=new Jt,r=new Jt,o=new je,a=new Zl,l=new Jl,c={},u=e.maxTextureSize,f={[Ks]:jn,[jn]:Ks,[ts]:ts},h=new Qi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Jt},radius:{value:4}},vertexShader:tb,fragmentShader:eb}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let g=new vn;g.setAttribute("position",new Ji(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Si(g,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=wa;let p=this.type;this.render=function(E,_,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===gp&&(qt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=wa);let V=n.getRenderTarget(),F=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),D=n.state;D.setBlending(_r),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let G=p!==this.type;G&&_.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(W=>W.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,W=E.length;P<W;P++){let O=E[P],N=O.shadow;if(N===void 0){qt("WebGLShadowMap:",O,"has no shadow.");continue}if(N.autoUpdate===!1&&N.needsUpdate===!1)continue;s.copy(N.mapSize);let J=N.getFrameExtents();s.multiply(J),r.copy(N.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/J.x),s.x=r.x*J.x,N.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/J.y),s.y=r.y*J.y,N.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(N.camera._reversedDepth=X,N.map===null||G===!0){if(N.map!==null&&(N.map.depthTexture!==null&&(N.map.depthTexture.dispose(),N.map.depthTexture=null),N.map.dispose()),this.type===_o){if(O.isPointLight){qt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}N.map=new ui(s.x,s.y,{format:js,type:Ui,minFilter:Jn,magFilter:Jn,generateMipmaps:!1}),N.map.texture.name=O.name+".shadowMap",N.map.depthTexture=new Ms(s.x,s.y,Ni),N.map.depthTexture.name=O.name+".shadowMapDepth",N.map.depthTexture.format=vs,N.map.depthTexture.compareFunction=null,N.map.depthTexture.minFilter=In,N.map.depthTexture.magFilter=In}else O.isPointLight?(N.map=new Na(s.x),N.map.depthTexture=new ua(s.x,Di)):(N.map=new ui(s.x,s.y),N.map.depthTexture=new Ms(s.x,s.y,Di)),N.map.depthTexture.name=O.name+".shadowMap",N.map.depthTexture.format=vs,this.type===wa?(N.map.depthTexture.compareFunction=X?Hu:Gu,N.map.depthTexture.minFilter=Jn,N.map.depthTexture.magFilter=Jn):(N.map.depthTexture.compareFunction=null,N.map.depthTexture.minFilter=In,N.map.depthTexture.magFilter=In);N.camera.updateProjectionMatrix()}N.map.isWebGLCubeRenderTarget!==!0&&(N.map.width!==s.x||N.map.height!==s.y)&&N.map.setSize(s.x,s.y);let Z=N.map.isWebGLCubeRenderTarget?6:N.getViewportCount();O.isPointLight!==!0&&N.updateMatrices(O,T);let nt=(N.camera.layers.mask&4294967294)!==0?N.camera.layers:T.layers;for(let ft=0;ft<Z;ft++){let ut=N.getCamera(ft);if(O.isPointLight){let et=N.camera,mt=N.matrix,xt=O.distance||et.far;xt!==et.far&&(et.far=xt,et.updateProjectionMatrix()),La.setFromMatrixPosition(O.matrixWorld),et.position.copy(La),lf.copy(et.position),lf.add(nb[ft]),et.up.copy(ib[ft]),et.lookAt(lf),et.updateMatrixWorld(),mt.makeTranslation(-La.x,-La.y,-La.z),bm.multiplyMatrices(et.projectionMatrix,et.matrixWorldInverse),N._frustum.setFromProjectionMatrix(bm,et.coordinateSystem,et.reversedDepth)}if(N.map.isWebGLCubeRenderTarget)n.setRenderTarget(N.map,ft),n.clear();else{ft===0&&(n.setRenderTarget(N.map),n.clear());let et=N.getViewport(ft);o.set(r.x*et.x,r.y*et.y,r.x*et.z,r.y*et.w),D.viewport(o)}i=N.getFrustum(ft),M(_,T,ut,O,nt,this.type)}N.isPointLightShadow!==!0&&this.type===_o&&y(N,T),N.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(V,F,L)};function y(E,_){let T=t.update(v);h.defines.VSM_SAMPLES!==E.blurSamples&&(h.defines.VSM_SAMPLES=E.blurSamples,d.defines.VSM_SAMPLES=E.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),E.mapPass===null?E.mapPass=new ui(s.x,s.y,{format:js,type:Ui}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),h.uniforms.shadow_pass.value=E.map.depthTexture,h.uniforms.resolution.value.set(E.map.width,E.map.height),h.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(_,null,T,h,v,null),d.uniforms.shadow_pass.value=E.mapPass.texture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(_,null,T,d,v,null)}function A(E,_,T,V){let F=null,L=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)F=L;else if(F=T.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let D=F.uuid,G=_.uuid,P=c[D];P===void 0&&(P={},c[D]=P);let W=P[G];W===void 0&&(W=F.clone(),P[G]=W,_.addEventListener("dispose",R)),F=W}if(F.visible=_.visible,F.wireframe=_.wireframe,V===_o?F.side=_.shadowSide!==null?_.shadowSide:_.side:F.side=_.shadowSide!==null?_.shadowSide:f[_.side],F.alphaMap=_.alphaMap,F.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,F.map=_.map,F.clipShadows=_.clipShadows,F.clippingPlanes=_.clippingPlanes,F.clipIntersection=_.clipIntersection,F.displacementMap=_.displacementMap,F.displacementScale=_.displacementScale,F.displacementBias=_.displacementBias,F.wireframeLinewidth=_.wireframeLinewidth,F.linewidth=_.linewidth,T.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let D=n.properties.get(F);D.light=T}return F}function M(E,_,T,V,F,L){if(E.visible===!1)return;if(E.layers.test(F)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===_o)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let P=t.update(E),W=E.material;if(Array.isArray(W)){let O=P.groups;for(let N=0,J=O.length;N<J;N++){let X=O[N],Z=W[X.materialIndex];if(Z&&Z.visible){let nt=A(E,Z,V,L);E.onBeforeShadow(n,E,_,T,P,nt,X),n.renderBufferDirect(T,null,P,nt,E,X),E.onAfterShadow(n,E,_,T,P,nt,X)}}}else if(W.visible){let O=A(E,W,V,L);E.onBeforeShadow(n,E,_,T,P,O,null),n.renderBufferDirect(T,null,P,O,E,null),E.onAfterShadow(n,E,_,T,P,O,null)}}let G=E.children;for(let P=0,W=G.length;P<W;P++)M(G[P],_,T,V,F,L)}function R(E){E.target.removeEventListener("dispose",R);for(let T in c){let V=c[T],F=E.target.uuid;F in V&&(V[F].dispose(),delete V[F])}}}function rb(n,t){function e(){let B=!1,ot=new je,st=null,wt=new je(0,0,0,0);return{setMask:function(gt){st!==gt&&!B&&(n.colorMask(gt,gt,gt,gt),st=gt)},setLocked:function(gt){B=gt},setClear:function(gt,St,Ht,jt,ct){ct===!0&&(gt*=jt,St*=jt,Ht*=jt),ot.set(gt,St,Ht,jt),wt.equals(ot)===!1&&(n.clearColor(gt,St,Ht,jt),wt.copy(ot))},reset:function(){B=!1,st=null,wt.set(-1,0,0,0)}}}function i(){let B=!1,ot=!1,st=null,wt=null,gt=null;return{setReversed:function(St){if(ot!==St){let Ht=t.get("EXT_clip_control");St?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),ot=St;let jt=gt;gt=null,this.setClear(jt)}},getReversed:function(){return ot},setTest:function(St){St?Mt(n.DEPTH_TEST):Wt(n.DEPTH_TEST)},setMask:function(St){st!==St&&!B&&(n.depthMask(St),st=St)},setFunc:function(St){if(ot&&(St=Jp[St]),wt!==St){switch(St){case Pl:n.depthFunc(n.NEVER);break;case Il:n.depthFunc(n.ALWAYS);break;case Ll:n.depthFunc(n.LESS);break;case io:n.depthFunc(n.LEQUAL);break;case Dl:n.depthFunc(n.EQUAL);break;case Nl:n.depthFunc(n.GEQUAL);break;case Ul:n.depthFunc(n.GREATER);break;case Fl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}wt=St}},setLocked:function(St){B=St},setClear:function(St){gt!==St&&(gt=St,ot&&(St=1-St),n.clearDepth(St))},reset:function(){B=!1,st=null,wt=null,gt=null,ot=!1}}}function s(){let B=!1,ot=null,st=null,wt=null,gt=null,St=null,Ht=null,jt=null,ct=null;return{setTest:function(Bt){B||(Bt?Mt(n.STENCIL_TEST):Wt(n.STENCIL_TEST))},setMask:function(Bt){ot!==Bt&&!B&&(n.stencilMask(Bt),ot=Bt)},setFunc:function(Bt,Qt,Rt){(st!==Bt||wt!==Qt||gt!==Rt)&&(n.stencilFunc(Bt,Qt,Rt),st=Bt,wt=Qt,gt=Rt)},setOp:function(Bt,Qt,Rt){(St!==Bt||Ht!==Qt||jt!==Rt)&&(n.stencilOp(Bt,Qt,Rt),St=Bt,Ht=Qt,jt=Rt)},setLocked:function(Bt){B=Bt},setClear:function(Bt){ct!==Bt&&(n.clearStencil(Bt),ct=Bt)},reset:function(){B=!1,ot=null,st=null,wt=null,gt=null,St=null,Ht=null,jt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,g=[],v=null,m=!1,p=null,y=null,A=null,M=null,R=null,E=null,_=null,T=new ce(0,0,0),V=0,F=!1,L=null,D=null,G=null,P=null,W=null,O=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),N=!1,J=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(J=parseFloat(/^WebGL (\d)/.exec(X)[1]),N=J>=1):X.indexOf("OpenGL ES")!==-1&&(J=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),N=J>=2);let Z=null,nt={},ft=n.getParameter(n.SCISSOR_BOX),ut=n.getParameter(n.VIEWPORT),et=new je().fromArray(ft),mt=new je().fromArray(ut);function xt(B,ot,st,wt){let gt=new Uint8Array(4),St=n.createTexture();n.bindTexture(B,St),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ht=0;Ht<st;Ht++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(ot,0,n.RGBA,1,1,wt,0,n.RGBA,n.UNSIGNED_BYTE,gt):n.texImage2D(ot+Ht,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,gt);return St}let Ct={};Ct[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),Ct[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ct[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ct[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(n.DEPTH_TEST),o.setFunc(io),cn(!1),Ue(Su),Mt(n.CULL_FACE),Je(_r);function Mt(B){u[B]!==!0&&(n.enable(B),u[B]=!0)}function Wt(B){u[B]!==!1&&(n.disable(B),u[B]=!1)}function ae(B,ot){return h[B]!==ot?(n.bindFramebuffer(B,ot),h[B]=ot,B===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=ot),B===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=ot),!0):!1}function Gt(B,ot){let st=g,wt=!1;if(B){st=d.get(ot),st===void 0&&(st=[],d.set(ot,st));let gt=B.textures;if(st.length!==gt.length||st[0]!==n.COLOR_ATTACHMENT0){for(let St=0,Ht=gt.length;St<Ht;St++)st[St]=n.COLOR_ATTACHMENT0+St;st.length=gt.length,wt=!0}}else st[0]!==n.BACK&&(st[0]=n.BACK,wt=!0);wt&&n.drawBuffers(st)}function pe(B){return v!==B?(n.useProgram(B),v=B,!0):!1}let ue={[xr]:n.FUNC_ADD,[xp]:n.FUNC_SUBTRACT,[vp]:n.FUNC_REVERSE_SUBTRACT};ue[yp]=n.MIN,ue[Sp]=n.MAX;let re={[Mp]:n.ZERO,[bp]:n.ONE,[wp]:n.SRC_COLOR,[Tu]:n.SRC_ALPHA,[Pp]:n.SRC_ALPHA_SATURATE,[Cp]:n.DST_COLOR,[Ep]:n.DST_ALPHA,[Tp]:n.ONE_MINUS_SRC_COLOR,[Eu]:n.ONE_MINUS_SRC_ALPHA,[Rp]:n.ONE_MINUS_DST_COLOR,[Ap]:n.ONE_MINUS_DST_ALPHA,[Ip]:n.CONSTANT_COLOR,[Lp]:n.ONE_MINUS_CONSTANT_COLOR,[Dp]:n.CONSTANT_ALPHA,[Np]:n.ONE_MINUS_CONSTANT_ALPHA};function Je(B,ot,st,wt,gt,St,Ht,jt,ct,Bt){if(B===_r){m===!0&&(Wt(n.BLEND),m=!1);return}if(m===!1&&(Mt(n.BLEND),m=!0),B!==_p){if(B!==p||Bt!==F){if((y!==xr||R!==xr)&&(n.blendEquation(n.FUNC_ADD),y=xr,R=xr),Bt)switch(B){case xo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Mu:n.blendFunc(n.ONE,n.ONE);break;case bu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case wu:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:te("WebGLState: Invalid blending: ",B);break}else switch(B){case xo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Mu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case bu:te("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case wu:te("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:te("WebGLState: Invalid blending: ",B);break}A=null,M=null,E=null,_=null,T.set(0,0,0),V=0,p=B,F=Bt}return}gt=gt||ot,St=St||st,Ht=Ht||wt,(ot!==y||gt!==R)&&(n.blendEquationSeparate(ue[ot],ue[gt]),y=ot,R=gt),(st!==A||wt!==M||St!==E||Ht!==_)&&(n.blendFuncSeparate(re[st],re[wt],re[St],re[Ht]),A=st,M=wt,E=St,_=Ht),(jt.equals(T)===!1||ct!==V)&&(n.blendColor(jt.r,jt.g,jt.b,ct),T.copy(jt),V=ct),p=B,F=!1}function He(B,ot){B.side===ts?Wt(n.CULL_FACE):Mt(n.CULL_FACE);let st=B.side===jn;ot&&(st=!st),cn(st),B.blending===xo&&B.transparent===!1?Je(_r):Je(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let wt=B.stencilWrite;a.setTest(wt),wt&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),be(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Mt(n.SAMPLE_ALPHA_TO_COVERAGE):Wt(n.SAMPLE_ALPHA_TO_COVERAGE)}function cn(B){L!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),L=B)}function Ue(B){B!==pp?(Mt(n.CULL_FACE),B!==D&&(B===Su?n.cullFace(n.BACK):B===mp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Wt(n.CULL_FACE),D=B}function Tn(B){B!==G&&(N&&n.lineWidth(B),G=B)}function be(B,ot,st){B?(Mt(n.POLYGON_OFFSET_FILL),(P!==ot||W!==st)&&(P=ot,W=st,o.getReversed()&&(ot=-ot,st=-st),n.polygonOffset(ot,st))):Wt(n.POLYGON_OFFSET_FILL)}function _n(B){B?Mt(n.SCISSOR_TEST):Wt(n.SCISSOR_TEST)}function en(B){B===void 0&&(B=n.TEXTURE0+O-1),Z!==B&&(n.activeTexture(B),Z=B)}function hn(B,ot,st){st===void 0&&(Z===null?st=n.TEXTURE0+O-1:st=Z);let wt=nt[st];wt===void 0&&(wt={type:void 0,texture:void 0},nt[st]=wt),(wt.type!==B||wt.texture!==ot)&&(Z!==st&&(n.activeTexture(st),Z=st),n.bindTexture(B,ot||Ct[B]),wt.type=B,wt.texture=ot)}function z(){let B=nt[Z];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Pt(){try{n.compressedTexImage2D(...arguments)}catch(B){te("WebGLState:",B)}}function Yt(){try{n.compressedTexImage3D(...arguments)}catch(B){te("WebGLState:",B)}}function le(){try{n.texSubImage2D(...arguments)}catch(B){te("WebGLState:",B)}}function bt(){try{n.texSubImage3D(...arguments)}catch(B){te("WebGLState:",B)}}function Be(){try{n.compressedTexSubImage2D(...arguments)}catch(B){te("WebGLState:",B)}}function Vt(){try{n.compressedTexSubImage3D(...arguments)}catch(B){te("WebGLState:",B)}}function $t(){try{n.texStorage2D(...arguments)}catch(B){te("WebGLState:",B)}}function C(){try{n.texStorage3D(...arguments)}catch(B){te("WebGLState:",B)}}function S(){try{n.texImage2D(...arguments)}catch(B){te("WebGLState:",B)}}function q(){try{n.texImage3D(...arguments)}catch(B){te("WebGLState:",B)}}function ht(B){return f[B]!==void 0?f[B]:n.getParameter(B)}function at(B,ot){f[B]!==ot&&(n.pixelStorei(B,ot),f[B]=ot)}function _t(B){et.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),et.copy(B))}function vt(B){mt.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),mt.copy(B))}function it(B,ot){let st=c.get(ot);st===void 0&&(st=new WeakMap,c.set(ot,st));let wt=st.get(B);wt===void 0&&(wt=n.getUniformBlockIndex(ot,B.name),n.uniformBlockBinding(ot,wt,wt),st.set(B,wt))}function rt(B,ot,st){let gt=c.get(ot).get(B);l[gt]!==st&&(n.bindBufferBase(n.UNIFORM_BUFFER,gt,st),l[gt]=st)}function pt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},Z=null,nt={},h={},l={},d=new WeakMap,g=[],v=null,m=!1,p=null,y=null,A=null,M=null,R=null,E=null,_=null,T=new ce(0,0,0),V=0,F=!1,L=null,D=null,G=null,P=null,W=null,et.set(0,0,n.canvas.width,n.canvas.height),mt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Wt,bindFramebuffer:ae,drawBuffers:Gt,useProgram:pe,setBlending:Je,setMaterial:He,setFlipSided:cn,setCullFace:Ue,setLineWidth:Tn,setPolygonOffset:be,setScissorTest:_n,activeTexture:en,bindTexture:hn,unbindTexture:z,compressedTexImage2D:Pt,compressedTexImage3D:Yt,texImage2D:S,texImage3D:q,pixelStorei:at,getParameter:ht,updateUBOMapping:it,uniformBlockBinding:rt,texStorage2D:$t,texStorage3D:C,texSubImage2D:le,texSubImage3D:bt,compressedTexSubImage2D:Be,compressedTexSubImage3D:Vt,scissor:_t,viewport:vt,reset:pt}}function ob(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Jt,u=new WeakMap,f=new Set,h,d=new WeakMap,g=new Set,v=new FinalizationRegistry(C=>g.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(C,S){return m?new OffscreenCanvas(C,S):sa("canvas")}function y(C,S,q){let ht=1,at=$t(C);if((at.width>q||at.height>q)&&(ht=q/Math.max(at.width,at.height)),ht<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let _t=Math.floor(ht*at.width),vt=Math.floor(ht*at.height);h===void 0&&(h=p(_t,vt));let it=S?p(_t,vt):h;return it.width=_t,it.height=vt,it.getContext("2d").drawImage(C,0,0,_t,vt),qt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+_t+"x"+vt+")."),it}else return"data"in C&&qt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),C;return C}function A(C){return C.generateMipmaps}function M(C){n.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(C,S,q,ht,at,_t=!1){if(C!==null){if(n[C]!==void 0)return n[C];qt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let vt;ht&&(vt=t.get("EXT_texture_norm16"),vt||qt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=S;if(S===n.RED&&(q===n.FLOAT&&(it=n.R32F),q===n.HALF_FLOAT&&(it=n.R16F),q===n.UNSIGNED_BYTE&&(it=n.R8),q===n.UNSIGNED_SHORT&&vt&&(it=vt.R16_EXT),q===n.SHORT&&vt&&(it=vt.R16_SNORM_EXT)),S===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(it=n.R8UI),q===n.UNSIGNED_SHORT&&(it=n.R16UI),q===n.UNSIGNED_INT&&(it=n.R32UI),q===n.BYTE&&(it=n.R8I),q===n.SHORT&&(it=n.R16I),q===n.INT&&(it=n.R32I)),S===n.RG&&(q===n.FLOAT&&(it=n.RG32F),q===n.HALF_FLOAT&&(it=n.RG16F),q===n.UNSIGNED_BYTE&&(it=n.RG8),q===n.UNSIGNED_SHORT&&vt&&(it=vt.RG16_EXT),q===n.SHORT&&vt&&(it=vt.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(it=n.RG8UI),q===n.UNSIGNED_SHORT&&(it=n.RG16UI),q===n.UNSIGNED_INT&&(it=n.RG32UI),q===n.BYTE&&(it=n.RG8I),q===n.SHORT&&(it=n.RG16I),q===n.INT&&(it=n.RG32I)),S===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(it=n.RGB8UI),q===n.UNSIGNED_SHORT&&(it=n.RGB16UI),q===n.UNSIGNED_INT&&(it=n.RGB32UI),q===n.BYTE&&(it=n.RGB8I),q===n.SHORT&&(it=n.RGB16I),q===n.INT&&(it=n.RGB32I)),S===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(it=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(it=n.RGBA16UI),q===n.UNSIGNED_INT&&(it=n.RGBA32UI),q===n.BYTE&&(it=n.RGBA8I),q===n.SHORT&&(it=n.RGBA16I),q===n.INT&&(it=n.RGBA32I)),S===n.RGB&&(q===n.UNSIGNED_SHORT&&vt&&(it=vt.RGB16_EXT),q===n.SHORT&&vt&&(it=vt.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(it=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(it=n.R11F_G11F_B10F)),S===n.RGBA){let rt=_t?ia:Se.getTransfer(at);q===n.FLOAT&&(it=n.RGBA32F),q===n.HALF_FLOAT&&(it=n.RGBA16F),q===n.UNSIGNED_BYTE&&(it=rt===Pe?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&vt&&(it=vt.RGBA16_EXT),q===n.SHORT&&vt&&(it=vt.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(it=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(it=n.RGB5_A1)}return(it===n.R16F||it===n.R32F||it===n.RG16F||it===n.RG32F||it===n.RGBA16F||it===n.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function _(C,S){let q;return C?S===null||S===Di||S===yr?q=n.DEPTH24_STENCIL8:S===Ni?q=n.DEPTH32F_STENCIL8:S===yo&&(q=n.DEPTH24_STENCIL8,qt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Di||S===yr?q=n.DEPTH_COMPONENT24:S===Ni?q=n.DEPTH_COMPONENT32F:S===yo&&(q=n.DEPTH_COMPONENT16),q}function T(C,S){return A(C)===!0||C.isFramebufferTexture&&C.minFilter!==In&&C.minFilter!==Jn?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function V(C){let S=new WeakRef(C);i.get(C).__ref=S,g.add(S),v.register(C,S,S)}function F(C){let S=i.get(C).__ref;S!==void 0&&(g.delete(S),v.unregister(S))}function L(C){G(C.target)}function D(C){P(C.target)}function G(C){C.removeEventListener("dispose",L),F(C),O(C),C.isVideoTexture&&u.delete(C),C.isHTMLTexture&&f.delete(C)}function P(C){C.removeEventListener("dispose",D),F(C),J(C)}function W(){for(let C of g){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?P(S):G(S))}g.clear(),f.clear()}function O(C){let S=i.get(C);if(S.__webglInit===void 0)return;let q=C.source,ht=d.get(q);if(ht){let at=ht[S.__cacheKey];at.usedTimes--,at.usedTimes===0&&N(C),Object.keys(ht).length===0&&d.delete(q)}i.remove(C)}function N(C){let S=i.get(C);n.deleteTexture(S.__webglTexture);let q=C.source,ht=d.get(q);delete ht[S.__cacheKey],o.memory.textures--}function J(C){let S=i.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=C.depthTexture;if(q&&q.renderTarget===C&&G(q),C.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(S.__webglFramebuffer[at]))for(let _t=0;_t<S.__webglFramebuffer[at].length;_t++)n.deleteFramebuffer(S.__webglFramebuffer[at][_t]);else n.deleteFramebuffer(S.__webglFramebuffer[at]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[at])}else{if(Array.isArray(S.__webglFramebuffer))for(let at=0;at<S.__webglFramebuffer.length;at++)n.deleteFramebuffer(S.__webglFramebuffer[at]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let at=0;at<S.__webglColorRenderbuffer.length;at++)S.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[at]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ht=C.textures;for(let at=0,_t=ht.length;at<_t;at++){let vt=i.get(ht[at]);vt.__webglTexture&&(n.deleteTexture(vt.__webglTexture),o.memory.textures--),i.remove(ht[at])}i.remove(C)}let X=0;function Z(){X=0}function nt(){return X}function ft(C){X=C}function ut(){let C=X;return C>=s.maxTextures&&qt("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,C}function et(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function mt(C,S){let q=i.get(C);if(C.isVideoTexture&&Be(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&q.__version!==C.version){let ht=C.image;if(ht===null)qt("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)qt("WebGLRenderer: Texture marked for update but image is incomplete");else{He(q,C,S);return}}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+S)}function xt(C,S){let q=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){He(q,C,S);return}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+S)}function Ct(C,S){let q=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){He(q,C,S);return}e.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+S)}function Mt(C,S){let q=i.get(C);if(C.version>0&&q.__version!==C.version){cn(q,C,S);return}e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+S)}let Wt={[Ol]:n.REPEAT,[Zi]:n.CLAMP_TO_EDGE,[Bl]:n.MIRRORED_REPEAT},ae={[In]:n.NEAREST,[Op]:n.NEAREST_MIPMAP_NEAREST,[Ta]:n.NEAREST_MIPMAP_LINEAR,[Jn]:n.LINEAR,[dc]:n.LINEAR_MIPMAP_NEAREST,[bs]:n.LINEAR_MIPMAP_LINEAR},Gt={[Vp]:n.NEVER,[Wu]:n.ALWAYS,[Gp]:n.LESS,[Gu]:n.LEQUAL,[Hp]:n.EQUAL,[Hu]:n.GEQUAL,[Wp]:n.GREATER,[Xp]:n.NOTEQUAL};function pe(C,S){if(S.type===Ni&&t.has("OES_texture_float_linear")===!1&&(S.magFilter===Jn||S.magFilter===dc||S.magFilter===Ta||S.magFilter===bs||S.minFilter===Jn||S.minFilter===dc||S.minFilter===Ta||S.minFilter===bs)&&qt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,Wt[S.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,Wt[S.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,Wt[S.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,ae[S.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,ae[S.minFilter]),S.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,Gt[S.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===In||S.minFilter!==Ta&&S.minFilter!==bs||S.type===Ni&&t.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");n.texParameterf(C,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function ue(C,S){let q=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",L),V(S));let ht=S.source,at=d.get(ht);at===void 0&&(at={},d.set(ht,at));let _t=et(S);if(_t!==C.__cacheKey){at[_t]===void 0&&(at[_t]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),at[_t].usedTimes++;let vt=at[C.__cacheKey];vt!==void 0&&(at[C.__cacheKey].usedTimes--,vt.usedTimes===0&&N(S)),C.__cacheKey=_t,C.__webglTexture=at[_t].texture}return q}function re(C,S,q){return Math.floor(Math.floor(C/q)/S)}function Je(C,S,q,ht){let _t=C.updateRanges;if(_t.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,q,ht,S.data);else{_t.sort((B,ot)=>B.start-ot.start);let vt=0;for(let B=1;B<_t.length;B++){let ot=_t[vt],st=_t[B],wt=ot.start+ot.count,gt=re(st.start,S.width,4),St=re(ot.start,S.width,4);st.start<=wt+1&&gt===St&&re(st.start+st.count-1,S.width,4)===gt?ot.count=Math.max(ot.count,st.start+st.count-ot.start):(++vt,_t[vt]=st)}_t.length=vt+1;let it=e.getParameter(n.UNPACK_ROW_LENGTH),rt=e.getParameter(n.UNPACK_SKIP_PIXELS),pt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let B=0,ot=_t.length;B<ot;B++){let st=_t[B],wt=Math.floor(st.start/4),gt=Math.ceil(st.count/4),St=wt%S.width,Ht=Math.floor(wt/S.width),jt=gt,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,St),e.pixelStorei(n.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(n.TEXTURE_2D,0,St,Ht,jt,ct,q,ht,S.data)}C.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,it),e.pixelStorei(n.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,pt)}}function He(C,S,q){let ht=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ht=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ht=n.TEXTURE_3D);let at=ue(C,S),_t=S.source;e.bindTexture(ht,C.__webglTexture,n.TEXTURE0+q);let vt=i.get(_t);if(_t.version!==vt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ct=Se.getPrimaries(Se.workingColorSpace),Bt=S.colorSpace===Ts?null:Se.getPrimaries(S.colorSpace),Qt=S.colorSpace===Ts||ct===Bt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qt)}e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let rt=y(S.image,!1,s.maxTextureSize);rt=Vt(S,rt);let pt=r.convert(S.format,S.colorSpace),B=r.convert(S.type),ot=E(S.internalFormat,pt,B,S.normalized,S.colorSpace,S.isVideoTexture);pe(ht,S);let st,wt=S.mipmaps,gt=S.isVideoTexture!==!0,St=vt.__version===void 0||at===!0,Ht=_t.dataReady,jt=T(S,rt);if(S.isDepthTexture)ot=_(S.format===ws,S.type),St&&(gt?e.texStorage2D(n.TEXTURE_2D,1,ot,rt.width,rt.height):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,pt,B,null));else if(S.isDataTexture)if(wt.length>0){gt&&St&&e.texStorage2D(n.TEXTURE_2D,jt,ot,wt[0].width,wt[0].height);for(let ct=0,Bt=wt.length;ct<Bt;ct++)st=wt[ct],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,st.width,st.height,pt,B,st.data):e.texImage2D(n.TEXTURE_2D,ct,ot,st.width,st.height,0,pt,B,st.data);S.generateMipmaps=!1}else gt?(St&&e.texStorage2D(n.TEXTURE_2D,jt,ot,rt.width,rt.height),Ht&&Je(S,rt,pt,B)):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,pt,B,rt.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){gt&&St&&e.texStorage3D(n.TEXTURE_2D_ARRAY,jt,ot,wt[0].width,wt[0].height,rt.depth);for(let ct=0,Bt=wt.length;ct<Bt;ct++)if(st=wt[ct],S.format!==Fi)if(pt!==null)if(gt){if(Ht)if(S.layerUpdates.size>0){let Qt=tf(st.width,st.height,S.format,S.type);for(let Rt of S.layerUpdates){let he=st.data.subarray(Rt*Qt/st.data.BYTES_PER_ELEMENT,(Rt+1)*Qt/st.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Rt,st.width,st.height,1,pt,he)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,st.width,st.height,rt.depth,pt,st.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,ot,st.width,st.height,rt.depth,0,st.data,0,0);else qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else gt?Ht&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,st.width,st.height,rt.depth,pt,B,st.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,ot,st.width,st.height,rt.depth,0,pt,B,st.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{gt&&St&&e.texStorage2D(n.TEXTURE_2D,jt,ot,wt[0].width,wt[0].height);for(let ct=0,Bt=wt.length;ct<Bt;ct++)st=wt[ct],S.format!==Fi?pt!==null?gt?Ht&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,st.width,st.height,pt,st.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,ot,st.width,st.height,0,st.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,st.width,st.height,pt,B,st.data):e.texImage2D(n.TEXTURE_2D,ct,ot,st.width,st.height,0,pt,B,st.data)}else if(S.isDataArrayTexture)if(gt){if(St&&e.texStorage3D(n.TEXTURE_2D_ARRAY,jt,ot,rt.width,rt.height,rt.depth),Ht)if(S.layerUpdates.size>0){let ct=tf(rt.width,rt.height,S.format,S.type);for(let Bt of S.layerUpdates){let Qt=rt.data.subarray(Bt*ct/rt.data.BYTES_PER_ELEMENT,(Bt+1)*ct/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Bt,rt.width,rt.height,1,pt,B,Qt)}S.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,pt,B,rt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ot,rt.width,rt.height,rt.depth,0,pt,B,rt.data);else if(S.isData3DTexture)gt?(St&&e.texStorage3D(n.TEXTURE_3D,jt,ot,rt.width,rt.height,rt.depth),Ht&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,pt,B,rt.data)):e.texImage3D(n.TEXTURE_3D,0,ot,rt.width,rt.height,rt.depth,0,pt,B,rt.data);else if(S.isFramebufferTexture){if(St)if(gt)e.texStorage2D(n.TEXTURE_2D,jt,ot,rt.width,rt.height);else{let ct=rt.width,Bt=rt.height;for(let Qt=0;Qt<jt;Qt++)e.texImage2D(n.TEXTURE_2D,Qt,ot,ct,Bt,0,pt,B,null),ct>>=1,Bt>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),rt.parentNode!==ct){ct.appendChild(rt),f.add(S),ct.onpaint=Bt=>{let Qt=Bt.changedElements;for(let Rt of f)Qt.includes(Rt.image)&&(Rt.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,rt);else{let Qt=n.RGBA,Rt=n.RGBA,he=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Qt,Rt,he,rt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(wt.length>0){if(gt&&St){let ct=$t(wt[0]);e.texStorage2D(n.TEXTURE_2D,jt,ot,ct.width,ct.height)}for(let ct=0,Bt=wt.length;ct<Bt;ct++)st=wt[ct],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,pt,B,st):e.texImage2D(n.TEXTURE_2D,ct,ot,pt,B,st);S.generateMipmaps=!1}else if(gt){if(St){let ct=$t(rt);e.texStorage2D(n.TEXTURE_2D,jt,ot,ct.width,ct.height)}Ht&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,pt,B,rt)}else e.texImage2D(n.TEXTURE_2D,0,ot,pt,B,rt);A(S)&&S.mipmapsAutoUpdate===!0&&M(ht),vt.__version=_t.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function cn(C,S,q){if(S.image.length!==6)return;let ht=ue(C,S),at=S.source;e.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+q);let _t=i.get(at);if(at.version!==_t.__version||ht===!0){e.activeTexture(n.TEXTURE0+q);let vt=Se.getPrimaries(Se.workingColorSpace),it=S.colorSpace===Ts?null:Se.getPrimaries(S.colorSpace),rt=S.colorSpace===Ts||vt===it?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let pt=S.isCompressedTexture||S.image[0].isCompressedTexture,B=S.image[0]&&S.image[0].isDataTexture,ot=[];for(let Rt=0;Rt<6;Rt++)!pt&&!B?ot[Rt]=y(S.image[Rt],!0,s.maxCubemapSize):ot[Rt]=B?S.image[Rt].image:S.image[Rt],ot[Rt]=Vt(S,ot[Rt]);let st=ot[0],wt=r.convert(S.format,S.colorSpace),gt=r.convert(S.type),St=E(S.internalFormat,wt,gt,S.normalized,S.colorSpace),Ht=S.isVideoTexture!==!0,jt=_t.__version===void 0||ht===!0,ct=at.dataReady,Bt=T(S,st);pe(n.TEXTURE_CUBE_MAP,S);let Qt;if(S.isDepthTexture){if(St=_(S.format===ws,S.type),jt)if(Ht)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,St,st.width,st.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,st.width,st.height,0,wt,gt,null)}else if(pt){Ht&&jt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Bt,St,st.width,st.height);for(let Rt=0;Rt<6;Rt++){Qt=ot[Rt].mipmaps;for(let he=0;he<Qt.length;he++){let We=Qt[he];S.format!==Fi?wt!==null?Ht?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,0,0,We.width,We.height,wt,We.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,St,We.width,We.height,0,We.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,0,0,We.width,We.height,wt,gt,We.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,St,We.width,We.height,0,wt,gt,We.data)}}}else{if(Qt=S.mipmaps,Ht&&jt){Qt.length>0&&Bt++;let Rt=$t(ot[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Bt,St,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(B){Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,ot[Rt].width,ot[Rt].height,wt,gt,ot[Rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,ot[Rt].width,ot[Rt].height,0,wt,gt,ot[Rt].data);for(let he=0;he<Qt.length;he++){let Wn=Qt[he].image[Rt].image;Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,0,0,Wn.width,Wn.height,wt,gt,Wn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,St,Wn.width,Wn.height,0,wt,gt,Wn.data)}}else{Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,wt,gt,ot[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,wt,gt,ot[Rt]);for(let he=0;he<Qt.length;he++){let We=Qt[he];Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,0,0,wt,gt,We.image[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,St,wt,gt,We.image[Rt])}}}A(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),_t.__version=at.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function Ue(C,S,q,ht,at,_t){let vt=r.convert(q.format,q.colorSpace),it=r.convert(q.type),rt=E(q.internalFormat,vt,it,q.normalized,q.colorSpace),pt=i.get(S),B=i.get(q);if(B.__renderTarget=S,!pt.__hasExternalTextures){let ot=Math.max(1,S.width>>_t),st=Math.max(1,S.height>>_t);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,_t,rt,ot,st,S.depth,0,vt,it,null):e.texImage2D(at,_t,rt,ot,st,0,vt,it,null)}e.bindFramebuffer(n.FRAMEBUFFER,C),bt(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ht,at,B.__webglTexture,0,le(S)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ht,at,B.__webglTexture,_t),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Tn(C,S,q){if(n.bindRenderbuffer(n.RENDERBUFFER,C),S.depthBuffer){let ht=S.depthTexture,at=ht&&ht.isDepthTexture?ht.type:null,_t=_(S.stencilBuffer,at),vt=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;bt(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(S),_t,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(S),_t,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,_t,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,vt,n.RENDERBUFFER,C)}else{let ht=S.textures;for(let at=0;at<ht.length;at++){let _t=ht[at],vt=r.convert(_t.format,_t.colorSpace),it=r.convert(_t.type),rt=E(_t.internalFormat,vt,it,_t.normalized,_t.colorSpace);bt(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(S),rt,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(S),rt,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,rt,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function be(C,S,q){let ht=S.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(S.depthTexture);at.__renderTarget=S;let _t=ht?S.depthTexture.image[0]:S.depthTexture.image;(!at.__webglTexture||_t.width!==S.width||_t.height!==S.height)&&(_t.width=S.width,_t.height=S.height,S.depthTexture.needsUpdate=!0),ht?Mt(S.depthTexture,0):mt(S.depthTexture,0);let vt=at.__webglTexture,it=le(S),rt=ht?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pt=S.depthTexture.format===ws?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===vs)bt(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,rt,vt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,pt,rt,vt,0);else if(S.depthTexture.format===ws)bt(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,rt,vt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,pt,rt,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function _n(C){let S=i.get(C),q=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let ht=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ht){let at=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ht.removeEventListener("dispose",at)};ht.addEventListener("dispose",at),S.__depthDisposeCallback=at}S.__boundDepthTexture=ht}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ht=0;ht<6;ht++)be(S.__webglFramebuffer[ht],C,ht);else C.texture.mipmaps.length>0?be(S.__webglFramebuffer[0],C,0):be(S.__webglFramebuffer,C,0);else if(q){S.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ht]),S.__webglDepthbuffer[ht]===void 0)S.__webglDepthbuffer[ht]=n.createRenderbuffer(),Tn(S.__webglDepthbuffer[ht],C,!1);else{let at=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer[ht];n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,_t)}}else if(C.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),Tn(S.__webglDepthbuffer,C,!1);else{let at=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,_t)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function en(C,S,q){let ht=i.get(C);S!==void 0&&Ue(ht.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&_n(C)}function hn(C){let S=C.texture,q=i.get(C),ht=i.get(S);C.addEventListener("dispose",D),V(C);let at=C.textures,_t=C.isWebGLCubeRenderTarget===!0,vt=at.length>1;if(vt||(ht.__webglTexture===void 0&&(ht.__webglTexture=n.createTexture()),ht.__version=S.version,o.memory.textures++),_t){q.__webglFramebuffer=[];for(let it=0;it<6;it++)if(S.mipmaps.length>0){q.__webglFramebuffer[it]=[];for(let rt=0;rt<S.mipmaps.length;rt++)q.__webglFramebuffer[it][rt]=n.createFramebuffer()}else q.__webglFramebuffer[it]=n.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let it=0;it<S.mipmaps.length;it++)q.__webglFramebuffer[it]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(vt)for(let it=0,rt=at.length;it<rt;it++){let pt=i.get(at[it]);pt.__webglTexture===void 0&&(pt.__webglTexture=n.createTexture(),o.memory.textures++)}if(C.samples>0&&bt(C)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let it=0;it<at.length;it++){let rt=at[it];q.__webglColorRenderbuffer[it]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[it]);let pt=r.convert(rt.format,rt.colorSpace),B=r.convert(rt.type),ot=E(rt.internalFormat,pt,B,rt.normalized,rt.colorSpace,C.isXRRenderTarget===!0),st=le(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,st,ot,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+it,n.RENDERBUFFER,q.__webglColorRenderbuffer[it])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Tn(q.__webglDepthRenderbuffer,C,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_t){e.bindTexture(n.TEXTURE_CUBE_MAP,ht.__webglTexture),pe(n.TEXTURE_CUBE_MAP,S);for(let it=0;it<6;it++)if(S.mipmaps.length>0)for(let rt=0;rt<S.mipmaps.length;rt++)Ue(q.__webglFramebuffer[it][rt],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,rt);else Ue(q.__webglFramebuffer[it],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);A(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let it=0,rt=at.length;it<rt;it++){let pt=at[it],B=i.get(pt),ot=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(ot=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,B.__webglTexture),pe(ot,pt),Ue(q.__webglFramebuffer,C,pt,n.COLOR_ATTACHMENT0+it,ot,0),A(pt)&&M(ot)}e.unbindTexture()}else{let it=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(it=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(it,ht.__webglTexture),pe(it,S),S.mipmaps.length>0)for(let rt=0;rt<S.mipmaps.length;rt++)Ue(q.__webglFramebuffer[rt],C,S,n.COLOR_ATTACHMENT0,it,rt);else Ue(q.__webglFramebuffer,C,S,n.COLOR_ATTACHMENT0,it,0);A(S)?M(it):S.mipmaps.length>0&&n.texParameteri(it,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}C.depthBuffer&&_n(C)}function z(C){let S=C.textures;for(let q=0,ht=S.length;q<ht;q++){let at=S[q];if(A(at)&&at.mipmapsAutoUpdate===!0){let _t=R(C),vt=i.get(at).__webglTexture;e.bindTexture(_t,vt),M(_t),e.unbindTexture()}}}let Pt=[];function Yt(C){if(C.samples>0){if(bt(C)===!1){let S=C.textures,q=C.width,ht=C.height,at=n.COLOR_BUFFER_BIT,_t=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=i.get(C),it=S.length>1;if(it)for(let pt=0;pt<S.length;pt++)e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let pt=0;pt<S.length;pt++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),it){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let B=i.get(S[pt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,q,ht,0,0,q,ht,at,n.NEAREST),l===!0&&(Pt.length=0,Pt.push(n.COLOR_ATTACHMENT0+pt),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Pt.push(_t),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),it)for(let pt=0;pt<S.length;pt++){e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let B=i.get(S[pt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,B,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let S=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function le(C){return Math.min(s.maxSamples,C.samples)}function bt(C){let S=i.get(C);return C.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Be(C){let S=o.render.frame;u.get(C)!==S&&(u.set(C,S),C.update())}function Vt(C,S){let q=C.colorSpace,ht=C.format,at=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||q!==na&&q!==Ts&&(Se.getTransfer(q)===Pe?(ht!==Fi||at!==ti)&&qt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):te("WebGLTextures: Unsupported texture color space:",q)),S}function $t(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=ut,this.resetTextureUnits=Z,this.getTextureUnits=nt,this.setTextureUnits=ft,this.setTexture2D=mt,this.setTexture2DArray=xt,this.setTexture3D=Ct,this.setTextureCube=Mt,this.rebindTextures=en,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=_n,this.setupFrameBufferTexture=Ue,this.useMultisampledRTT=bt,this.dispose=W}function ab(n,t){function e(i,s=Ts){let r,o=Se.getTransfer(s);if(i===ti)return n.UNSIGNED_BYTE;if(i===mc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===gc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Ou)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Bu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Uu)return n.BYTE;if(i===Fu)return n.SHORT;if(i===yo)return n.UNSIGNED_SHORT;if(i===pc)return n.INT;if(i===Di)return n.UNSIGNED_INT;if(i===Ni)return n.FLOAT;if(i===Ui)return n.HALF_FLOAT;if(i===ku)return n.ALPHA;if(i===zu)return n.RGB;if(i===Fi)return n.RGBA;if(i===vs)return n.DEPTH_COMPONENT;if(i===ws)return n.DEPTH_STENCIL;if(i===Vu)return n.RED;if(i===_c)return n.RED_INTEGER;if(i===js)return n.RG;if(i===xc)return n.RG_INTEGER;if(i===vc)return n.RGBA_INTEGER;if(i===Ea||i===Aa||i===Ca||i===Ra)if(o===Pe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ea)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ca)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ea)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ca)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ra)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===yc||i===Sc||i===Mc||i===bc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===yc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Sc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Mc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===bc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===wc||i===Tc||i===Ec||i===Ac||i===Cc||i===Pa||i===Rc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===wc||i===Tc)return o===Pe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ec)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ac)return r.COMPRESSED_R11_EAC;if(i===Cc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Pa)return r.COMPRESSED_RG11_EAC;if(i===Rc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Pc||i===Ic||i===Lc||i===Dc||i===Nc||i===Uc||i===Fc||i===Oc||i===Bc||i===kc||i===zc||i===Vc||i===Gc||i===Hc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Pc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ic)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Lc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Dc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Nc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Uc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Fc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Oc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Bc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===kc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===zc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Vc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Gc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Hc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Wc||i===Xc||i===$c)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Wc)return o===Pe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Xc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===$c)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===qc||i===Yc||i===Ia||i===Zc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===qc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Yc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ia)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Zc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===yr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var lb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cb=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,mf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new fa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Qi({vertexShader:lb,fragmentShader:cb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Si(new da(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},gf=class extends Li{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,g=null,v=typeof XRWebGLBinding<"u",m=new mf,p={},y=e.getContextAttributes(),A=null,M=null,R=[],E=[],_=new Jt,T=null,V=null,F=new Zn;F.viewport=new je;let L=new Zn;L.viewport=new je;let D=[F,L],G=new lc,P=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(et){let mt=R[et];return mt===void 0&&(mt=new co,R[et]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(et){let mt=R[et];return mt===void 0&&(mt=new co,R[et]=mt),mt.getGripSpace()},this.getHand=function(et){let mt=R[et];return mt===void 0&&(mt=new co,R[et]=mt),mt.getHandSpace()};function O(et){let mt=E.indexOf(et.inputSource);if(mt===-1)return;let xt=R[mt];xt!==void 0&&(xt.update(et.inputSource,et.frame,c||o),xt.dispatchEvent({type:et.type,data:et.inputSource}))}function N(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",N),s.removeEventListener("inputsourceschange",J);for(let et=0;et<R.length;et++){let mt=E[et];mt!==null&&(E[et]=null,R[et].disconnect(mt))}P=null,W=null,m.reset();for(let et in p)delete p[et];if(t.setRenderTarget(A),d=null,h=null,f=null,s=null,M=null,ut.stop(),i.isPresenting=!1,t.setPixelRatio(T),t.setSize(_.width,_.height,!1),V!==null){let et=V.camera;et.fov=V.fov,et.zoom=V.zoom,et.updateProjectionMatrix(),V=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(et){r=et,i.isPresenting===!0&&qt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(et){a=et,i.isPresenting===!0&&qt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(et){c=et},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&v&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(et){if(s=et,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",N),s.addEventListener("inputsourceschange",J),y.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(_),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Ct=null,Mt=null;y.depth&&(Mt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=y.stencil?ws:vs,Ct=y.stencil?yr:Di);let Wt={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Wt),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),M=new ui(h.textureWidth,h.textureHeight,{format:Fi,type:ti,depthTexture:new Ms(h.textureWidth,h.textureHeight,Ct,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let xt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new ui(d.framebufferWidth,d.framebufferHeight,{format:Fi,type:ti,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ut.setContext(s),ut.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function J(et){for(let mt=0;mt<et.removed.length;mt++){let xt=et.removed[mt],Ct=E.indexOf(xt);Ct>=0&&(E[Ct]=null,R[Ct].disconnect(xt))}for(let mt=0;mt<et.added.length;mt++){let xt=et.added[mt],Ct=E.indexOf(xt);if(Ct===-1){for(let Wt=0;Wt<R.length;Wt++)if(Wt>=E.length){E.push(xt),Ct=Wt;break}else if(E[Wt]===null){E[Wt]=xt,Ct=Wt;break}if(Ct===-1)break}let Mt=R[Ct];Mt&&Mt.connect(xt)}}function X(et,mt){mt===null?et.matrixWorld.copy(et.matrix):et.matrixWorld.multiplyMatrices(mt.matrixWorld,et.matrix),et.matrixWorldInverse.copy(et.matrixWorld).invert()}this.updateCamera=function(et){if(s===null)return;let mt=et.near,xt=et.far;m.texture!==null&&(m.depthNear>0&&(mt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),G.near=L.near=F.near=mt,G.far=L.far=F.far=xt,(P!==G.near||W!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),P=G.near,W=G.far),G.layers.mask=et.layers.mask|6,F.layers.mask=G.layers.mask&-5,L.layers.mask=G.layers.mask&-3;let Ct=et.parent,Mt=G.cameras;X(G,Ct);for(let Wt=0;Wt<Mt.length;Wt++)X(Mt[Wt],Ct);G.projectionMatrix.copy(F.projectionMatrix),G.projectionMatrixInverse.copy(F.projectionMatrixInverse),V===null&&et.isPerspectiveCamera&&(V={camera:et,fov:et.fov,zoom:et.zoom}),Z(et,G,Ct)};function Z(et,mt,xt){xt===null?et.matrix.copy(mt.matrixWorld):(et.matrix.copy(xt.matrixWorld),et.matrix.invert(),et.matrix.multiply(mt.matrixWorld)),et.matrix.decompose(et.position,et.quaternion,et.scale),et.updateMatrixWorld(!0),et.projectionMatrix.copy(mt.projectionMatrix),et.projectionMatrixInverse.copy(mt.projectionMatrixInverse),et.isPerspectiveCamera&&(et.fov=oo*2*Math.atan(1/et.projectionMatrix.elements[5]),et.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(et){l=et,h!==null&&(h.fixedFoveation=et),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=et)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(et){return p[et]};let nt=null;function ft(et,mt){if(u=mt.getViewerPose(c||o),g=mt,u!==null){let xt=u.views;d!==null&&(t.setRenderTargetFramebuffer(M,d.framebuffer),t.setRenderTarget(M));let Ct=!1;xt.length!==G.cameras.length&&(G.cameras.length=0,Ct=!0);for(let Gt=0;Gt<xt.length;Gt++){let pe=xt[Gt],ue=null;if(d!==null)ue=d.getViewport(pe);else{let Je=f.getViewSubImage(h,pe);ue=Je.viewport,Gt===0&&(t.setRenderTargetTextures(M,Je.colorTexture,Je.depthStencilTexture),t.setRenderTarget(M))}let re=D[Gt];re===void 0&&(re=new Zn,re.layers.enable(Gt),re.viewport=new je,D[Gt]=re),re.matrix.fromArray(pe.transform.matrix),re.matrix.decompose(re.position,re.quaternion,re.scale),re.projectionMatrix.fromArray(pe.projectionMatrix),re.projectionMatrixInverse.copy(re.projectionMatrix).invert(),re.viewport.set(ue.x,ue.y,ue.width,ue.height),Gt===0&&(G.matrix.copy(re.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ct===!0&&G.cameras.push(re)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){f=i.getBinding();let Gt=f.getDepthInformation(xt[0]);Gt&&Gt.isValid&&Gt.texture&&m.init(Gt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&v){t.state.unbindTexture(),f=i.getBinding();for(let Gt=0;Gt<xt.length;Gt++){let pe=xt[Gt].camera;if(pe){let ue=p[pe];ue||(ue=new fa,p[pe]=ue);let re=f.getCameraImage(pe);ue.sourceTexture=re}}}}for(let xt=0;xt<R.length;xt++){let Ct=E[xt],Mt=R[xt];Ct!==null&&Mt!==void 0&&Mt.update(Ct,mt,c||o)}nt&&nt(et,mt),mt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:mt}),g=null}let ut=new wm;ut.setAnimationLoop(ft),this.setAnimationLoop=function(et){nt=et},this.dispose=function(){}}},hb=new ke,Nm=new ie;Nm.set(-1,0,0,0,1,0,0,0,1);function ub(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Ku(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,y,A,M){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),f(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),h(m,p),p.isMeshPhysicalMaterial&&d(m,p,M)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,y,A):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===jn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===jn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let y=t.get(p),A=y.envMap,M=y.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(hb.makeRotationFromEuler(M)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Nm),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,y,A){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*y,m.scale.value=A*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function f(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function h(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,y){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===jn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){let y=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function fb(n,t,e,i){let s={},r={};function o(y,A){let M=A.program;i.uniformBlockBinding(y,M,s[y.id])}function a(y,A){let M=s[y.id];M===void 0&&(g(y),M=l(y),s[y.id]=M,y.addEventListener("dispose",m));let R=A.program;i.updateUBOMapping(y,R);let E=t.render.frame;r[y.id]!==E&&(c(y),r[y.id]=E)}function l(y){let A=n.createBuffer(),M=y.__size,R=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,M,R),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(y){let A=s[y.id],M=y.uniforms,R=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let E=0,_=M.length;E<_;E++){let T=M[E];if(Array.isArray(T))for(let V=0,F=T.length;V<F;V++)u(T[V],E,V,R);else u(T,E,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,A,M,R){if(h(y,A,M,R)===!0){let E=y.__offset,_=y.value;if(Array.isArray(_)){let T=0;for(let V=0;V<_.length;V++){let F=_[V],L=v(F,!0);f(F,y.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,y.__data)}}function f(y,A,M){typeof y=="number"||typeof y=="boolean"?A[M]=y:y.isMatrix3?(A[M]=y.elements[0],A[M+1]=y.elements[1],A[M+2]=y.elements[2],A[M+3]=0,A[M+4]=y.elements[3],A[M+5]=y.elements[4],A[M+6]=y.elements[5],A[M+7]=0,A[M+8]=y.elements[6],A[M+9]=y.elements[7],A[M+10]=y.elements[8],A[M+11]=0):ArrayBuffer.isView(y)?A.set(y.subarray(0,A.length-M),M):y.toArray(A,M)}function h(y,A,M,R){let E=y.value,_=A+"_"+M;if(Array.isArray(E)){R[_]===void 0&&(R[_]=[]);let T=R[_],V=!1;for(let F=0;F<E.length;F++)d(E[F],T,F)===!0&&(V=!0);return V}return d(E,R,_)}function d(y,A,M){if(A[M]===void 0)return typeof y=="number"||typeof y=="boolean"?A[M]=y:ArrayBuffer.isView(y)?A[M]=y.slice():A[M]=y.clone(),!0;{let R=A[M];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return A[M]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function g(y){let A=y.uniforms,M=0,R=16;for(let _=0,T=A.length;_<T;_++){let V=Array.isArray(A[_])?A[_]:[A[_]];for(let F=0,L=V.length;F<L;F++){let D=V[F],G=Array.isArray(D.value)?D.value:[D.value],P=Array.isArray(A[_])||Array.isArray(D.value),W=M;for(let N=0,J=G.length;N<J;N++){let X=G[N],Z=v(X,P),nt=M%R,ft=nt%Z.boundary,ut=nt+ft;M+=ft,ut!==0&&R-ut<Z.storage&&(M+=R-ut),N===0&&(W=M),M+=Z.storage}let O=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new O((M-W)/Float32Array.BYTES_PER_ELEMENT),D.__offset=W}}let E=M%R;return E>0&&(M+=R-E),y.__size=M,y.__cache={},this}function v(y,A){let M={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(M.boundary=4,M.storage=4):y.isVector2?(M.boundary=8,M.storage=8):y.isVector3||y.isColor?(M.boundary=16,M.storage=12):y.isVector4?(M.boundary=16,M.storage=16):y.isMatrix3?(M.boundary=16,M.storage=48):y.isMatrix4?(M.boundary=16,M.storage=64):y.isTexture?qt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(M.boundary=16,M.storage=y.byteLength):qt("WebGLRenderer: Unsupported uniform value type.",y),A===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(y){let A=y.target;A.removeEventListener("dispose",m),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function p(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:p}}var db=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ns=null;function pb(){return ns===null&&(ns=new Wl(db,16,16,js,Ui),ns.name="DFG_LUT",ns.minFilter=Jn,ns.magFilter=Jn,ns.wrapS=Zi,ns.wrapT=Zi,ns.generateMipmaps=!1,ns.needsUpdate=!0),ns}var th=class{constructor(t={}){let{canvas:e=qp(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=ti}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let v=d,m=new Set([vc,xc,_c]),p=new Set([ti,Di,yo,yr,mc,gc]),y=new Uint32Array(4),A=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},R=null,E=null,_=[],T=[],V=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=es,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,L=!1,D=null,G=null,P=null,W=null;this._outputColorSpace=ci;let O=0,N=0,J=null,X=-1,Z=null,nt=new je,ft=new je,ut=null,et=new ce(0),mt=0,xt=e.width,Ct=e.height,Mt=1,Wt=null,ae=null,Gt=new je(0,0,xt,Ct),pe=new je(0,0,xt,Ct),ue=!1,re=new Hs,Je=new Xl,He=!1,cn=!1,Ue=new ke,Tn=new Y,be=new je,_n={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function hn(){return J===null?Mt:1}let z=i;function Pt(w,H){return e.getContext(w,H)}let Yt,le,bt,Be,Vt,$t,C,S,q,ht,at,_t,vt,it,rt,pt,B,ot,st,wt,gt,St,Ht;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Bt,!1),e.addEventListener("webglcontextrestored",Qt,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),z===null){let H="webgl2";if(z=Pt(H,w),z===null)throw Pt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}jt()}catch(w){throw e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",Qt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),te("WebGLRenderer: "+w.message),w}function jt(){Yt=new TS(z),Yt.init(),gt=new ab(z,Yt),le=new pS(z,Yt,t,gt),bt=new rb(z,Yt),le.reversedDepthBuffer&&h&&bt.buffers.depth.setReversed(!0),G=z.createFramebuffer(),P=z.createFramebuffer(),W=z.createFramebuffer(),Be=new CS(z),Vt=new XM,$t=new ob(z,Yt,bt,Vt,le,gt,Be),C=new wS(F),S=new Px(z),St=new fS(z,S),q=new ES(z,S,Be,St),ht=new PS(z,q,S,St,Be),ot=new RS(z,le,$t),rt=new mS(Vt),at=new WM(F,C,Yt,le,St,rt),_t=new ub(F,Vt),vt=new qM,it=new QM(Yt),B=new uS(F,C,bt,ht,g,l),pt=new sb(F,ht,le),Ht=new fb(z,Be,le,bt),st=new dS(z,Yt,Be),wt=new AS(z,Yt,Be),Be.programs=at.programs,F.capabilities=le,F.extensions=Yt,F.properties=Vt,F.renderLists=vt,F.shadowMap=pt,F.state=bt,F.info=Be}v!==ti&&(V=new LS(v,e.width,e.height,a,s,r));let ct=new gf(F,z);this.xr=ct,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let w=Yt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Yt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(w){w!==void 0&&(Mt=w,this.setSize(xt,Ct,!1))},this.getSize=function(w){return w.set(xt,Ct)},this.setSize=function(w,H,tt=!0){if(ct.isPresenting){qt("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=w,Ct=H,e.width=Math.floor(w*Mt),e.height=Math.floor(H*Mt),tt===!0&&(e.style.width=w+"px",e.style.height=H+"px"),V!==null&&V.setSize(e.width,e.height),this.setViewport(0,0,w,H)},this.getDrawingBufferSize=function(w){return w.set(xt*Mt,Ct*Mt).floor()},this.setDrawingBufferSize=function(w,H,tt){xt=w,Ct=H,Mt=tt,e.width=Math.floor(w*tt),e.height=Math.floor(H*tt),this.setViewport(0,0,w,H)},this.setEffects=function(w){if(v===ti){te("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let H=0;H<w.length;H++)if(w[H].isOutputPass===!0){qt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}V.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(nt)},this.getViewport=function(w){return w.copy(Gt)},this.setViewport=function(w,H,tt,K){w.isVector4?Gt.set(w.x,w.y,w.z,w.w):Gt.set(w,H,tt,K),bt.viewport(nt.copy(Gt).multiplyScalar(hn()).round())},this.getScissor=function(w){return w.copy(pe)},this.setScissor=function(w,H,tt,K){w.isVector4?pe.set(w.x,w.y,w.z,w.w):pe.set(w,H,tt,K),bt.scissor(ft.copy(pe).multiplyScalar(hn()).round())},this.getScissorTest=function(){return ue},this.setScissorTest=function(w){bt.setScissorTest(ue=w)},this.setOpaqueSort=function(w){Wt=w},this.setTransparentSort=function(w){ae=w},this.getClearColor=function(w){return w.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(w=!0,H=!0,tt=!0){let K=0;if(w){let j=!1;if(J!==null){let Tt=J.texture.format;j=m.has(Tt)}if(j){let Tt=J.texture.type,It=p.has(Tt),Et=B.getClearColor(),Lt=B.getClearAlpha(),zt=Et.r,ee=Et.g,me=Et.b;It?(y[0]=zt,y[1]=ee,y[2]=me,y[3]=Lt,z.clearBufferuiv(z.COLOR,0,y)):(A[0]=zt,A[1]=ee,A[2]=me,A[3]=Lt,z.clearBufferiv(z.COLOR,0,A))}else K|=z.COLOR_BUFFER_BIT}H&&(K|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),tt&&(K|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&z.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),D=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",Qt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),B.dispose(),vt.dispose(),it.dispose(),$t.dispose(),Vt.dispose(),C.dispose(),ht.dispose(),q.dispose(),St.dispose(),Ht.dispose(),at.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",Ya),ct.removeEventListener("sessionend",Vi),as.stop()};function Bt(w){w.preventDefault(),$u("WebGLRenderer: Context Lost."),L=!0}function Qt(){$u("WebGLRenderer: Context Restored."),L=!1;let w=Be.autoReset,H=pt.enabled,tt=pt.autoUpdate,K=pt.needsUpdate,j=pt.type;jt(),Be.autoReset=w,pt.enabled=H,pt.autoUpdate=tt,pt.needsUpdate=K,pt.type=j}function Rt(w){te("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function he(w){let H=w.target;H.removeEventListener("dispose",he),We(H)}function We(w){Wn(w),Vt.remove(w)}function Wn(w){let H=Vt.get(w).programs;H!==void 0&&(H.forEach(function(tt){at.releaseProgram(tt)}),w.isShaderMaterial&&at.releaseShaderCache(w))}this.renderBufferDirect=function(w,H,tt,K,j,Tt){H===null&&(H=_n);let It=j.isMesh&&j.matrixWorld.determinantAffine()<0,Et=Vo(w,H,tt,K,j);bt.setMaterial(K,It);let Lt=tt.index,zt=1;if(K.wireframe===!0){if(Lt=q.getWireframeAttribute(tt),Lt===void 0)return;zt=2}let ee=tt.drawRange,me=tt.attributes.position,kt=ee.start*zt,ge=(ee.start+ee.count)*zt;Tt!==null&&(kt=Math.max(kt,Tt.start*zt),ge=Math.min(ge,(Tt.start+Tt.count)*zt)),Lt!==null?(kt=Math.max(kt,0),ge=Math.min(ge,Lt.count)):me!=null&&(kt=Math.max(kt,0),ge=Math.min(ge,me.count));let Qe=ge-kt;if(Qe<0||Qe===1/0)return;St.setup(j,K,Et,tt,Lt);let Le,De=st;if(Lt!==null&&(Le=S.get(Lt),De=wt,De.setIndex(Le)),j.isMesh)K.wireframe===!0?(bt.setLineWidth(K.wireframeLinewidth*hn()),De.setMode(z.LINES)):De.setMode(z.TRIANGLES);else if(j.isLine){let xn=K.linewidth;xn===void 0&&(xn=1),bt.setLineWidth(xn*hn()),j.isLineSegments?De.setMode(z.LINES):j.isLineLoop?De.setMode(z.LINE_LOOP):De.setMode(z.LINE_STRIP)}else j.isPoints?De.setMode(z.POINTS):j.isSprite&&De.setMode(z.TRIANGLES);if(j.isBatchedMesh)if(Yt.get("WEBGL_multi_draw"))De.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let xn=j._multiDrawStarts,Ft=j._multiDrawCounts,un=j._multiDrawCount,ve=Lt?S.get(Lt).bytesPerElement:1,cs=Vt.get(K).currentProgram.getUniforms();for(let fn=0;fn<un;fn++)cs.setValue(z,"_gl_DrawID",fn),De.render(xn[fn]/ve,Ft[fn])}else if(j.isInstancedMesh)De.renderInstances(kt,Qe,j.count);else if(tt.isInstancedBufferGeometry){let xn=tt._maxInstanceCount!==void 0?tt._maxInstanceCount:1/0,Ft=Math.min(tt.instanceCount,xn);De.renderInstances(kt,Qe,Ft)}else De.render(kt,Qe)};function Bo(w,H,tt,K){D!==null&&w.isNodeMaterial&&D.setObject(K,w),He===!0&&rt.setState(w,tt,!1),w.transparent===!0&&w.side===ts&&w.forceSinglePass===!1?(w.side=jn,w.needsUpdate=!0,Gi(w,H,K),w.side=Ks,w.needsUpdate=!0,Gi(w,H,K),w.side=ts):Gi(w,H,K)}this.compile=function(w,H,tt=null){tt===null&&(tt=w),D!==null&&D.renderStart(w,H,tt),E=it.get(tt),E.init(H),T.push(E),tt.traverseVisible(function(j){j.isLight&&j.layers.test(H.layers)&&(E.pushLight(j),j.castShadow&&E.pushShadow(j))}),w!==tt&&w.traverseVisible(function(j){j.isLight&&j.layers.test(H.layers)&&(E.pushLight(j),j.castShadow&&E.pushShadow(j))}),E.setupLights(),D!==null&&D.updateLights(E.state.lightsArray),cn=this.localClippingEnabled,He=rt.init(this.clippingPlanes,cn),He===!0&&rt.setGlobalState(this.clippingPlanes,H),D!==null&&pt.render(E.state.shadowsArray,tt,H);let K=new Set;return w.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Tt=j.material;if(Tt)if(Array.isArray(Tt))for(let It=0;It<Tt.length;It++){let Et=Tt[It];Bo(Et,tt,H,j),K.add(Et)}else Bo(Tt,tt,H,j),K.add(Tt)}),E=T.pop(),D!==null&&D.renderEnd(),K},this.compileAsync=function(w,H,tt=null){let K=this.compile(w,H,tt);return new Promise(j=>{function Tt(){if(K.forEach(function(It){let Lt=Vt.get(It).currentProgram;(Lt===void 0||Lt.isReady())&&K.delete(It)}),K.size===0){j(w);return}setTimeout(Tt,10)}Yt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Ir=null;function Lh(w){Ir&&Ir(w)}function Ya(){as.stop()}function Vi(){as.start()}let as=new wm;as.setAnimationLoop(Lh),typeof self<"u"&&as.setContext(self),this.setAnimationLoop=function(w){Ir=w,ct.setAnimationLoop(w),w===null?as.stop():as.start()},ct.addEventListener("sessionstart",Ya),ct.addEventListener("sessionend",Vi),this.render=function(w,H){if(H!==void 0&&H.isCamera!==!0){te("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;D!==null&&D.renderStart(w,H);let tt=ct.enabled===!0&&ct.isPresenting===!0,K=V!==null&&(J===null||tt)&&V.begin(F,J);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(V===null||V.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(H),H=ct.getCamera()),w.isScene===!0&&w.onBeforeRender(F,w,H,J),E=it.get(w,T.length),E.init(H),E.state.textureUnits=$t.getTextureUnits(),T.push(E),Ue.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?Je.setFromArrayCamera(H):re.setFromProjectionMatrix(Ue,yi,H.reversedDepth),cn=this.localClippingEnabled,He=rt.init(this.clippingPlanes,cn),R=vt.get(w,_.length),R.init(),_.push(R),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let It=F.xr.getDepthSensingMesh();It!==null&&ls(It,H,-1/0,F.sortObjects)}ls(w,H,0,F.sortObjects),R.finish(),D!==null&&D.updateLights(E.state.lightsArray),F.sortObjects===!0&&R.sort(Wt,ae),en=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,en&&B.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),He===!0&&rt.beginShadows();let j=E.state.shadowsArray;if(pt.render(j,w,H),He===!0&&rt.endShadows(),(K&&V.hasRenderPass())===!1){let It=R.opaque,Et=R.transmissive;if(E.setupLights(),H.isArrayCamera){let Lt=H.cameras;if(Et.length>0)for(let zt=0,ee=Lt.length;zt<ee;zt++){let me=Lt[zt];Ti(It,Et,w,me)}en&&B.render(w);for(let zt=0,ee=Lt.length;zt<ee;zt++){let me=Lt[zt];ko(R,w,me,me.viewport)}}else Et.length>0&&Ti(It,Et,w,H),en&&B.render(w),ko(R,w,H)}J!==null&&N===0&&($t.updateMultisampleRenderTarget(J),$t.updateRenderTargetMipmap(J)),K&&V.end(F),w.isScene===!0&&w.onAfterRender(F,w,H),St.resetDefaultState(),X=-1,Z=null,T.pop(),T.length>0?(E=T[T.length-1],$t.setTextureUnits(E.state.textureUnits),He===!0&&rt.setGlobalState(F.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,D!==null&&D.renderEnd()};function ls(w,H,tt,K){if(w.visible===!1)return;if(w.layers.test(H.layers)){if(w.isGroup)tt=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(H);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let It=H.isArrayCamera?Je:re;if(!w.frustumCulled||w.intersectsFrustum(It)){K&&be.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ue);let Et=ht.update(w),Lt=w.material;Lt.visible&&R.push(w,Et,Lt,tt,be.z,null,H)}}else if(w.isMesh||w.isLine||w.isPoints){let It=H.isArrayCamera?Je:re;if(!w.frustumCulled||w.intersectsFrustum(It)){let Et=ht.update(w),Lt=w.material;if(K&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),be.copy(w.boundingSphere.center)):(Et.boundingSphere===null&&Et.computeBoundingSphere(),be.copy(Et.boundingSphere.center)),be.applyMatrix4(w.matrixWorld).applyMatrix4(Ue)),Array.isArray(Lt)){let zt=Et.groups;for(let ee=0,me=zt.length;ee<me;ee++){let kt=zt[ee],ge=Lt[kt.materialIndex];ge&&ge.visible&&R.push(w,Et,ge,tt,be.z,kt,H)}}else Lt.visible&&R.push(w,Et,Lt,tt,be.z,null,H)}}}let Tt=w.children;for(let It=0,Et=Tt.length;It<Et;It++)ls(Tt[It],H,tt,K)}function ko(w,H,tt,K){let{opaque:j,transmissive:Tt,transparent:It}=w;E.setupLightsView(tt),He===!0&&rt.setGlobalState(F.clippingPlanes,tt),K&&bt.viewport(nt.copy(K)),j.length>0&&nn(j,H,tt),Tt.length>0&&nn(Tt,H,tt),It.length>0&&nn(It,H,tt),bt.buffers.depth.setTest(!0),bt.buffers.depth.setMask(!0),bt.buffers.color.setMask(!0),bt.setPolygonOffset(!1)}function Ti(w,H,tt,K){if((tt.isScene===!0?tt.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[K.id]===void 0){let kt=Yt.has("EXT_color_buffer_half_float")||Yt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[K.id]=new ui(1,1,{generateMipmaps:!0,type:kt?Ui:ti,minFilter:bs,samples:Math.max(4,le.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Se.workingColorSpace})}let Tt=E.state.transmissionRenderTarget[K.id],It=K.viewport||nt;Tt.setSize(It.z*F.transmissionResolutionScale,It.w*F.transmissionResolutionScale);let Et=F.getRenderTarget(),Lt=F.getActiveCubeFace(),zt=F.getActiveMipmapLevel();F.setRenderTarget(Tt),F.getClearColor(et),mt=F.getClearAlpha(),mt<1&&F.setClearColor(16777215,.5),F.clear(),en&&B.render(tt);let ee=F.toneMapping;F.toneMapping=es;let me=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),E.setupLightsView(K),He===!0&&rt.setGlobalState(F.clippingPlanes,K),nn(w,tt,K),$t.updateMultisampleRenderTarget(Tt),$t.updateRenderTargetMipmap(Tt),Yt.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let ge=0,Qe=H.length;ge<Qe;ge++){let Le=H[ge],{object:De,geometry:xn,material:Ft,group:un}=Le;if(Ft.side===ts&&De.layers.test(K.layers)){let ve=Ft.side;Ft.side=jn,Ft.needsUpdate=!0,an(De,tt,K,xn,Ft,un),Ft.side=ve,Ft.needsUpdate=!0,kt=!0}}kt===!0&&($t.updateMultisampleRenderTarget(Tt),$t.updateRenderTargetMipmap(Tt))}F.setRenderTarget(Et,Lt,zt),F.setClearColor(et,mt),me!==void 0&&(K.viewport=me),F.toneMapping=ee}function nn(w,H,tt){let K=H.isScene===!0?H.overrideMaterial:null;for(let j=0,Tt=w.length;j<Tt;j++){let It=w[j],{object:Et,geometry:Lt,group:zt}=It,ee=It.material;ee.allowOverride===!0&&K!==null&&(ee=K),Et.layers.test(tt.layers)&&an(Et,H,tt,Lt,ee,zt)}}function an(w,H,tt,K,j,Tt){D!==null&&j.isNodeMaterial&&D.setObject(w,j),w.onBeforeRender(F,H,tt,K,j,Tt),w.modelViewMatrix.multiplyMatrices(tt.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),j.onBeforeRender(F,H,tt,K,w,Tt),j.transparent===!0&&j.side===ts&&j.forceSinglePass===!1?(j.side=jn,j.needsUpdate=!0,F.renderBufferDirect(tt,H,K,j,w,Tt),j.side=Ks,j.needsUpdate=!0,F.renderBufferDirect(tt,H,K,j,w,Tt),j.side=ts):F.renderBufferDirect(tt,H,K,j,w,Tt),w.onAfterRender(F,H,tt,K,j,Tt)}function ln(w){let H=0;for(let tt of w)tt.texture!==null&&H++;return H}function Gi(w,H,tt){H.isScene!==!0&&(H=_n);let K=Vt.get(w),j=E.state.lights,Tt=E.state.shadowsArray,It=j.state.version,Et=at.getParameters(w,j.state,Tt,H,tt,E.state.lightProbeGridArray),Lt=at.getProgramCacheKey(Et),zt=K.programs;K.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?H.environment:null,K.fog=H.fog;let ee=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;K.envMap=C.get(w.envMap||K.environment,ee),K.envMapRotation=K.environment!==null&&w.envMap===null?H.environmentRotation:w.envMapRotation,zt===void 0&&(w.addEventListener("dispose",he),zt=new Map,K.programs=zt,K.programVariants=new Map);let me=zt.get(Lt);if(me!==void 0){if(K.currentProgram===me&&K.lightsStateVersion===It)return zo(w,Et),me}else Et.uniforms=at.getUniforms(w),D!==null&&w.isNodeMaterial&&D.build(w,tt,Et),w.onBeforeCompile(Et,F),me=at.acquireProgram(Et,Lt),zt.set(Lt,me),K.uniforms=Et.uniforms;let kt=K.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(kt.clippingPlanes=rt.uniform),zo(w,Et),K.needsLights=Ps(w),K.lightsStateVersion=It,K.needsLights&&(kt.ambientLightColor.value=j.state.ambient,kt.lightProbe.value=j.state.probe,kt.sunLights.value=j.state.sun,kt.sunLightShadows.value=j.state.sunShadow,kt.directionalLights.value=j.state.directional,kt.directionalLightShadows.value=j.state.directionalShadow,kt.spotLights.value=j.state.spot,kt.spotLightShadows.value=j.state.spotShadow,kt.rectAreaLights.value=j.state.rectArea,kt.ltc_1.value=j.state.rectAreaLTC1,kt.ltc_2.value=j.state.rectAreaLTC2,kt.pointLights.value=j.state.point,kt.pointLightShadows.value=j.state.pointShadow,kt.hemisphereLights.value=j.state.hemi,kt.sunShadowMatrix.value=j.state.sunShadowMatrix,kt.sunShadowCascade.value=j.state.sunShadowCascade,kt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,kt.spotLightMatrix.value=j.state.spotLightMatrix,kt.spotLightMap.value=j.state.spotLightMap,kt.pointShadowMatrix.value=j.state.pointShadowMatrix),K.numLightProbeGrids=ln(E.state.lightProbeGridArray),K.currentProgram=me,K.uniformsList=null,me}function ii(w,H,tt,K,j){let Tt=Vt.get(w),It=Tt.currentProgram.id+","+K+","+j,Et=Tt.programVariants.get(It);return Et===void 0?(Et=Gi(w,H,tt),Tt.programVariants.set(It,Et)):(Tt.currentProgram=Et,Tt.uniformsList=null,Tt.outputColorSpace=K,Tt.toneMapping=j),Et}function Rs(w){if(w.uniformsList===null){let H=w.currentProgram.getUniforms();w.uniformsList=Mo.seqWithValue(H.seq,w.uniforms)}return w.uniformsList}function zo(w,H){let tt=Vt.get(w);tt.outputColorSpace=H.outputColorSpace,tt.batching=H.batching,tt.batchingColor=H.batchingColor,tt.instancing=H.instancing,tt.instancingColor=H.instancingColor,tt.instancingMorph=H.instancingMorph,tt.skinning=H.skinning,tt.morphTargets=H.morphTargets,tt.morphNormals=H.morphNormals,tt.morphColors=H.morphColors,tt.morphTargetsCount=H.morphTargetsCount,tt.numClippingPlanes=H.numClippingPlanes,tt.numIntersection=H.numClipIntersection,tt.vertexAlphas=H.vertexAlphas,tt.vertexTangents=H.vertexTangents,tt.toneMapping=H.toneMapping}function Vo(w,H,tt,K,j){H.isScene!==!0&&(H=_n),$t.resetTextureUnits();let Tt=H.fog,It=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?H.environment:null,Et=J===null?F.outputColorSpace:J.isXRRenderTarget===!0?J.texture.colorSpace:Se.workingColorSpace,Lt=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,zt=C.get(K.envMap||It,Lt),ee=K.vertexColors===!0&&!!tt.attributes.color&&tt.attributes.color.itemSize===4,me=!!tt.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),kt=!!tt.morphAttributes.position,ge=!!tt.morphAttributes.normal,Qe=!!tt.morphAttributes.color,Le=es;K.toneMapped&&(J===null||J.isXRRenderTarget===!0)&&(Le=F.toneMapping);let De=tt.morphAttributes.position||tt.morphAttributes.normal||tt.morphAttributes.color,xn=De!==void 0?De.length:0,Ft=Vt.get(K),un=E.state.lights;if(He===!0&&(cn===!0||w!==Z)){let Ne=w===Z&&K.id===X;rt.setState(K,w,Ne)}let ve=!1,cs=!1;K.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==un.state.version||j.isBatchedMesh&&Ft.batching===!1||!j.isBatchedMesh&&Ft.batching===!0||j.isBatchedMesh&&Ft.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Ft.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Ft.instancing===!1||!j.isInstancedMesh&&Ft.instancing===!0||j.isSkinnedMesh&&Ft.skinning===!1||!j.isSkinnedMesh&&Ft.skinning===!0||j.isInstancedMesh&&Ft.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Ft.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Ft.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Ft.instancingMorph===!1&&j.morphTexture!==null||Ft.envMap!==zt||K.fog===!0&&Ft.fog!==Tt||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==rt.numPlanes||Ft.numIntersection!==rt.numIntersection)||Ft.vertexAlphas!==ee||Ft.vertexTangents!==me||Ft.morphTargets!==kt||Ft.morphNormals!==ge||Ft.morphColors!==Qe||Ft.morphTargetsCount!==xn||Ft.numLightProbeGrids!==ln(E.state.lightProbeGridArray)?ve=!0:(Ft.outputColorSpace!==Et||Ft.toneMapping!==Le)&&(cs=!0):(ve=!0,Ft.__version=K.version);let fn=Ft.currentProgram;(ve===!0||cs===!0)&&(fn=cs===!0?ii(K,H,j,Et,Le):Gi(K,H,j),D&&K.isNodeMaterial&&D.onUpdateProgram(K,fn,Ft));let Nr=!1,Hi=!1,hs=!1,fe=fn.getUniforms(),sn=Ft.uniforms;if(bt.useProgram(fn.program)&&(Nr=!0,Hi=!0,hs=!0),K.id!==X&&(X=K.id,Hi=!0),Nr||Z!==w){bt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),fe.setValue(z,"projectionMatrix",w.projectionMatrix),fe.setValue(z,"viewMatrix",w.matrixWorldInverse);let dn=fe.map.cameraPosition;dn!==void 0&&dn.setValue(z,Tn.setFromMatrixPosition(w.matrixWorld)),le.logarithmicDepthBuffer&&fe.setValue(z,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&fe.setValue(z,"isOrthographic",w.isOrthographicCamera===!0),Z!==w&&(Z=w,Hi=!0,hs=!0)}if(Ft.needsLights&&(un.state.sunShadowMap.length>0&&fe.setValue(z,"sunShadowMap",un.state.sunShadowMap,$t),un.state.directionalShadowMap.length>0&&fe.setValue(z,"directionalShadowMap",un.state.directionalShadowMap,$t),un.state.spotShadowMap.length>0&&fe.setValue(z,"spotShadowMap",un.state.spotShadowMap,$t),un.state.pointShadowMap.length>0&&fe.setValue(z,"pointShadowMap",un.state.pointShadowMap,$t)),j.isSkinnedMesh){fe.setOptional(z,j,"bindMatrix"),fe.setOptional(z,j,"bindMatrixInverse");let Ne=j.skeleton;Ne&&(Ne.boneTexture===null&&Ne.computeBoneTexture(),fe.setValue(z,"boneTexture",Ne.boneTexture,$t))}j.isBatchedMesh&&(fe.setOptional(z,j,"batchingTexture"),fe.setValue(z,"batchingTexture",j._matricesTexture,$t),fe.setOptional(z,j,"batchingIdTexture"),fe.setValue(z,"batchingIdTexture",j._indirectTexture,$t),fe.setOptional(z,j,"batchingColorTexture"),j._colorsTexture!==null&&fe.setValue(z,"batchingColorTexture",j._colorsTexture,$t));let Xn=tt.morphAttributes;if((Xn.position!==void 0||Xn.normal!==void 0||Xn.color!==void 0)&&ot.update(j,tt,fn),(Hi||Ft.receiveShadow!==j.receiveShadow)&&(Ft.receiveShadow=j.receiveShadow,fe.setValue(z,"receiveShadow",j.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&H.environment!==null&&(sn.envMapIntensity.value=H.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=pb()),Hi){if(fe.setValue(z,"toneMappingExposure",F.toneMappingExposure),Ft.needsLights&&Lr(sn,hs),Tt&&K.fog===!0&&_t.refreshFogUniforms(sn,Tt),_t.refreshMaterialUniforms(sn,K,Mt,Ct,E.state.transmissionRenderTarget[w.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Ne=M,dn=0;for(let On of E.state.lightProbeGridArray)On.texture!==null&&(Ne.textures[dn]=On.texture,Ne.min[dn]=On.boundingBox.min,Ne.max[dn]=On.boundingBox.max,Ne.resolution[dn]=On.resolution,dn++);for(let On in Ne)Ne[On].length=dn;sn.probesSH.value=Ne.textures,sn.probesMin.value=Ne.min,sn.probesMax.value=Ne.max,sn.probesResolution.value=Ne.resolution}Mo.upload(z,Rs(Ft),sn,$t)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Mo.upload(z,Rs(Ft),sn,$t),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&fe.setValue(z,"center",j.center),fe.setValue(z,"modelViewMatrix",j.modelViewMatrix),fe.setValue(z,"normalMatrix",j.normalMatrix),fe.setValue(z,"modelMatrix",j.matrixWorld),K.uniformsGroups!==void 0){let Ne=K.uniformsGroups;for(let dn=0,On=Ne.length;dn<On;dn++){let Za=Ne[dn];Ht.update(Za,fn),Ht.bind(Za,fn)}}return fn}function Lr(w,H){w.ambientLightColor.needsUpdate=H,w.lightProbe.needsUpdate=H,w.sunLights.needsUpdate=H,w.sunLightShadows.needsUpdate=H,w.directionalLights.needsUpdate=H,w.directionalLightShadows.needsUpdate=H,w.pointLights.needsUpdate=H,w.pointLightShadows.needsUpdate=H,w.spotLights.needsUpdate=H,w.spotLightShadows.needsUpdate=H,w.rectAreaLights.needsUpdate=H,w.hemisphereLights.needsUpdate=H}function Ps(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return O},this.getActiveMipmapLevel=function(){return N},this.getRenderTarget=function(){return J},this.setRenderTargetTextures=function(w,H,tt){let K=Vt.get(w);K.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Vt.get(w.texture).__webglTexture=H,Vt.get(w.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:tt,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,H){let tt=Vt.get(w);tt.__webglFramebuffer=H,tt.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(w,H=0,tt=0){J=w,O=H,N=tt;let K=null,j=!1,Tt=!1;if(w){let Et=Vt.get(w);if(Et.__useDefaultFramebuffer!==void 0){bt.bindFramebuffer(z.FRAMEBUFFER,Et.__webglFramebuffer),nt.copy(w.viewport),ft.copy(w.scissor),ut=w.scissorTest,bt.viewport(nt),bt.scissor(ft),bt.setScissorTest(ut),X=-1;return}else if(Et.__webglFramebuffer===void 0)$t.setupRenderTarget(w);else if(Et.__hasExternalTextures)$t.rebindTextures(w,Vt.get(w.texture).__webglTexture,Vt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let ee=w.depthTexture;if(Et.__boundDepthTexture!==ee){if(ee!==null&&Vt.has(ee)&&(w.width!==ee.image.width||w.height!==ee.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$t.setupDepthRenderbuffer(w)}}let Lt=w.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(Tt=!0);let zt=Vt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(zt[H])?K=zt[H][tt]:K=zt[H],j=!0):w.samples>0&&$t.useMultisampledRTT(w)===!1?K=Vt.get(w).__webglMultisampledFramebuffer:Array.isArray(zt)?K=zt[tt]:K=zt,nt.copy(w.viewport),ft.copy(w.scissor),ut=w.scissorTest}else nt.copy(Gt).multiplyScalar(Mt).floor(),ft.copy(pe).multiplyScalar(Mt).floor(),ut=ue;if(tt!==0&&(K=G),bt.bindFramebuffer(z.FRAMEBUFFER,K)&&bt.drawBuffers(w,K),bt.viewport(nt),bt.scissor(ft),bt.setScissorTest(ut),j){let Et=Vt.get(w.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+H,Et.__webglTexture,tt)}else if(Tt){let Et=H;for(let Lt=0;Lt<w.textures.length;Lt++){let zt=Vt.get(w.textures[Lt]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Lt,zt.__webglTexture,tt,Et)}}else if(w!==null&&tt!==0){let Et=Vt.get(w.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Et.__webglTexture,tt)}X=-1};function Dr(w){let H=Vt.get(w);return(H.__readFormat!==w.format||H.__readType!==w.type)&&(H.__readFormat=w.format,H.__readType=w.type,H.__formatReadable=le.textureFormatReadable(w.format),H.__typeReadable=le.textureTypeReadable(w.type)),H}this.readRenderTargetPixels=function(w,H,tt,K,j,Tt,It,Et=0){if(!(w&&w.isWebGLRenderTarget)){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Lt=Vt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt){bt.bindFramebuffer(z.FRAMEBUFFER,Lt);try{let zt=w.textures[Et],ee=zt.format,me=zt.type;w.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Et);let kt=Dr(zt);if(kt.__formatReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=w.width-K&&tt>=0&&tt<=w.height-j&&z.readPixels(H,tt,K,j,gt.convert(ee),gt.convert(me),Tt)}finally{let zt=J!==null?Vt.get(J).__webglFramebuffer:null;bt.bindFramebuffer(z.FRAMEBUFFER,zt)}}},this.readRenderTargetPixelsAsync=async function(w,H,tt,K,j,Tt,It,Et=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Lt=Vt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt)if(H>=0&&H<=w.width-K&&tt>=0&&tt<=w.height-j){bt.bindFramebuffer(z.FRAMEBUFFER,Lt);let zt=w.textures[Et],ee=zt.format,me=zt.type;w.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Et);let kt=Dr(zt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ge=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,ge),z.bufferData(z.PIXEL_PACK_BUFFER,Tt.byteLength,z.STREAM_READ),z.readPixels(H,tt,K,j,gt.convert(ee),gt.convert(me),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let Qe=J!==null?Vt.get(J).__webglFramebuffer:null;bt.bindFramebuffer(z.FRAMEBUFFER,Qe);let Le=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await Zp(z,Le,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,ge),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Tt),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(ge),z.deleteSync(Le),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,H=null,tt=0){let K=Math.pow(2,-tt),j=Math.floor(w.image.width*K),Tt=Math.floor(w.image.height*K),It=H!==null?H.x:0,Et=H!==null?H.y:0;$t.setTexture2D(w,0),z.copyTexSubImage2D(z.TEXTURE_2D,tt,0,0,It,Et,j,Tt),bt.unbindTexture()},this.copyTextureToTexture=function(w,H,tt=null,K=null,j=0,Tt=0){let It,Et,Lt,zt,ee,me,kt,ge,Qe,Le=w.isCompressedTexture?w.mipmaps[Tt]:w.image;if(tt!==null)It=tt.max.x-tt.min.x,Et=tt.max.y-tt.min.y,Lt=tt.isBox3?tt.max.z-tt.min.z:1,zt=tt.min.x,ee=tt.min.y,me=tt.isBox3?tt.min.z:0;else{let fe=Math.pow(2,-j);It=Math.floor(Le.width*fe),Et=Math.floor(Le.height*fe),w.isDataArrayTexture?Lt=Le.depth:w.isData3DTexture?Lt=Math.floor(Le.depth*fe):Lt=1,zt=0,ee=0,me=0}K!==null?(kt=K.x,ge=K.y,Qe=K.z):(kt=0,ge=0,Qe=0);let De=gt.convert(H.format),xn=gt.convert(H.type),Ft;H.isData3DTexture?($t.setTexture3D(H,0),Ft=z.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?($t.setTexture2DArray(H,0),Ft=z.TEXTURE_2D_ARRAY):($t.setTexture2D(H,0),Ft=z.TEXTURE_2D),bt.activeTexture(z.TEXTURE0),bt.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,H.flipY),bt.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),bt.pixelStorei(z.UNPACK_ALIGNMENT,H.unpackAlignment);let un=bt.getParameter(z.UNPACK_ROW_LENGTH),ve=bt.getParameter(z.UNPACK_IMAGE_HEIGHT),cs=bt.getParameter(z.UNPACK_SKIP_PIXELS),fn=bt.getParameter(z.UNPACK_SKIP_ROWS),Nr=bt.getParameter(z.UNPACK_SKIP_IMAGES);bt.pixelStorei(z.UNPACK_ROW_LENGTH,Le.width),bt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Le.height),bt.pixelStorei(z.UNPACK_SKIP_PIXELS,zt),bt.pixelStorei(z.UNPACK_SKIP_ROWS,ee),bt.pixelStorei(z.UNPACK_SKIP_IMAGES,me);let Hi=w.isDataArrayTexture||w.isData3DTexture,hs=H.isDataArrayTexture||H.isData3DTexture;if(w.isDepthTexture){let fe=Vt.get(w),sn=Vt.get(H),Xn=Vt.get(fe.__renderTarget),Ne=Vt.get(sn.__renderTarget);bt.bindFramebuffer(z.READ_FRAMEBUFFER,Xn.__webglFramebuffer),bt.bindFramebuffer(z.DRAW_FRAMEBUFFER,Ne.__webglFramebuffer);for(let dn=0;dn<Lt;dn++)Hi&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Vt.get(w).__webglTexture,j,me+dn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Vt.get(H).__webglTexture,Tt,Qe+dn)),z.blitFramebuffer(zt,ee,zt+It,ee+Et,kt,ge,kt+It,ge+Et,z.DEPTH_BUFFER_BIT,z.NEAREST);bt.bindFramebuffer(z.READ_FRAMEBUFFER,null),bt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(j!==0||w.isRenderTargetTexture||Vt.has(w)){let fe=Vt.get(w),sn=Vt.get(H);bt.bindFramebuffer(z.READ_FRAMEBUFFER,P),bt.bindFramebuffer(z.DRAW_FRAMEBUFFER,W);for(let Xn=0;Xn<Lt;Xn++)Hi?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,fe.__webglTexture,j,me+Xn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,fe.__webglTexture,j),hs?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,sn.__webglTexture,Tt,Qe+Xn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,sn.__webglTexture,Tt),j!==0?z.blitFramebuffer(zt,ee,zt+It,ee+Et,kt,ge,kt+It,ge+Et,z.COLOR_BUFFER_BIT,z.NEAREST):hs?z.copyTexSubImage3D(Ft,Tt,kt,ge,Qe+Xn,zt,ee,It,Et):z.copyTexSubImage2D(Ft,Tt,kt,ge,zt,ee,It,Et);bt.bindFramebuffer(z.READ_FRAMEBUFFER,null),bt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else hs?w.isDataTexture||w.isData3DTexture?z.texSubImage3D(Ft,Tt,kt,ge,Qe,It,Et,Lt,De,xn,Le.data):H.isCompressedArrayTexture?z.compressedTexSubImage3D(Ft,Tt,kt,ge,Qe,It,Et,Lt,De,Le.data):z.texSubImage3D(Ft,Tt,kt,ge,Qe,It,Et,Lt,De,xn,Le):w.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Tt,kt,ge,It,Et,De,xn,Le.data):w.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Tt,kt,ge,Le.width,Le.height,De,Le.data):z.texSubImage2D(z.TEXTURE_2D,Tt,kt,ge,It,Et,De,xn,Le);bt.pixelStorei(z.UNPACK_ROW_LENGTH,un),bt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,ve),bt.pixelStorei(z.UNPACK_SKIP_PIXELS,cs),bt.pixelStorei(z.UNPACK_SKIP_ROWS,fn),bt.pixelStorei(z.UNPACK_SKIP_IMAGES,Nr),Tt===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&z.generateMipmap(Ft),bt.unbindTexture()},this.initRenderTarget=function(w){Vt.get(w).__webglFramebuffer===void 0&&$t.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?$t.setTextureCube(w,0):w.isData3DTexture?$t.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?$t.setTexture2DArray(w,0):$t.setTexture2D(w,0),bt.unbindTexture()},this.resetState=function(){O=0,N=0,J=null,bt.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return yi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Se._getDrawingBufferColorSpace(t),e.unpackColorSpace=Se._getUnpackColorSpace()}};var Om=new Y(0,1,0),Um=[[1,0,0],[0,1,0],[0,0,1]],mb=70,Fm=n=>new Y(n[3],n[7],n[11]);function gb(n,t,e){let i=e.clone().sub(t),s=i.length();n.visible=s>1,n.visible&&(n.position.copy(t).addScaledVector(i,.5),n.quaternion.copy(new zn().setFromUnitVectors(Om,i.normalize())),n.scale.set(1,s,1))}var Mr=class{constructor(t,{thickness:e,transparent:i,opacity:s,axes:r}){this.arm=t,this.material=new po({transparent:i,opacity:s,depthWrite:!i}),this.jointMaterial=new po({transparent:i,opacity:s,depthWrite:!i}),this.group=new Ii;let o=t.joints.length,a=new fo(e,e,1,20),l=new fo(e*1.45,e*1.45,e*3.2,24),c=new Xs(e*2.4,e*5,e*2.4),u=new pa(e,20,14),f=(h,d)=>{let g=new Si(h,d);return this.group.add(g),g};if(this.bars=Array.from({length:o+2},()=>f(a,this.material)),this.bars[o+1].scale.setScalar(.4),this.knees=Array.from({length:o+1},()=>f(u,this.material)),this.hubs=t.joints.map(h=>f(h.slides?c:l,this.jointMaterial)),r){let h=Um.flatMap(g=>[...g,...g].map(v=>.25+.6*v)),d=new vn;d.setAttribute("position",new Oe(new Float32Array((o+1)*18),3)),d.setAttribute("color",new Oe(Array.from({length:o+1},()=>h).flat(),3)),this.lines=new Ws(d,new ji({vertexColors:!0,depthTest:!1})),this.lines.frustumCulled=!1,this.group.add(this.lines)}}paint(t,e){this.material.color.set(t),this.jointMaterial.color.set(e)}pose(t,e,i={},s=1){let r=Ud(this.arm,t,i,s),o=this.arm.joints.length,a=Wh(r[o],e),l=[Fm(Hh()),...r.map(Fm),new Y(...a)];return this.bars.forEach((c,u)=>gb(c,l[u],l[u+1])),this.bars[o+1].scale.x=.35,this.bars[o+1].scale.z=.35,this.knees.forEach((c,u)=>c.position.copy(l[u+1])),this.hubs.forEach((c,u)=>{let f=r[u],[h,d,g]=this.arm.joints[u].axis,v=new Y(f[0]*h+f[1]*d+f[2]*g,f[4]*h+f[5]*d+f[6]*g,f[8]*h+f[9]*d+f[10]*g);c.position.copy(l[u+1]),c.quaternion.copy(new zn().setFromUnitVectors(Om,v))}),this.lines&&this.drawAxes(r),a}drawAxes(t){let{position:e}=this.lines.geometry.attributes;t.forEach((i,s)=>{Um.forEach((r,o)=>{let a=Wh(i,r.map(l=>l*mb));e.setXYZ(s*6+o*2,i[3],i[7],i[11]),e.setXYZ(s*6+o*2+1,...a)})}),e.needsUpdate=!0}};var sh=document.documentElement,Bm=matchMedia("(prefers-color-scheme: dark)"),km=new Set,_b=()=>sh.dataset.theme?sh.dataset.theme==="dark":Bm.matches,ih=new Map;function ze(n){return ih.has(n)||ih.set(n,getComputedStyle(sh).getPropertyValue(`--${n}`).trim()),ih.get(n)}var ss=n=>km.add(n);function zm(){ih.clear(),km.forEach(n=>n())}function _f(n){sh.dataset.theme=n==="dark"?"dark":"light",zm()}var Vm=()=>_f(_b()?"light":"dark");Bm.addEventListener("change",zm);function Gm(n=["scale-0","scale-1","scale-2"].map(ze)){let t=n.map(e=>[1,3,5].map(i=>parseInt(e.slice(i,i+2),16)/255));return(e,i,s)=>{let r=Math.min(Math.max(e,0),1)*(t.length-1),o=Math.min(Math.floor(r),t.length-2);for(let a=0;a<3;a+=1)i[s+a]=t[o][a]+(t[o+1][a]-t[o][a])*(r-o)}}var Hm=.28,xb=1500,vb=4e3;function yb(){let n=k("canvas",{width:64,height:64}),t=n.getContext("2d");return t.fillStyle="#fff",t.beginPath(),t.arc(32,32,30,0,2*Math.PI),t.fill(),new ha(n)}var rh=n=>new Oe(new Float32Array(n),3),wo=class{constructor(t){this.places=t,this.count=t.length/3,this.group=new Ii;let e=yb(),i=this.count>vb?{size:3}:{size:this.count>2e3?5:9,map:e,alphaTest:.5};this.geometry=new vn,this.geometry.setAttribute("position",new Oe(t,3)),this.geometry.setAttribute("color",rh(3*this.count)),this.dots=new uo(this.geometry,new gr({vertexColors:!0,sizeAttenuation:!1,...i})),this.path=new ho(this.geometry,new ji({transparent:this.count<=2e3,opacity:.55})),this.step=Math.max(Math.ceil(this.count/xb),1);let s=Math.ceil(this.count/this.step);this.arrows=new Ws(new vn,new ji({vertexColors:!0})),this.arrows.geometry.setAttribute("position",rh(18*s)),this.arrows.geometry.setAttribute("color",rh(18*s)),this.ring=new uo(new vn,new gr({size:17,map:e,alphaTest:.5,sizeAttenuation:!1,depthTest:!1,transparent:!0,opacity:.45})),this.ring.geometry.setAttribute("position",rh(3)),this.ring.visible=!1;for(let r of[this.path,this.arrows,this.ring,this.dots])r.frustumCulled=!1,this.group.add(r)}paint({path:t,ring:e}){this.path.material.color.set(t),this.ring.material.color.set(e)}mark(t){this.ring.visible=t!==null,t!==null&&(this.ring.geometry.attributes.position.setXYZ(0,...this.places.slice(3*t,3*t+3)),this.ring.geometry.attributes.position.needsUpdate=!0)}show(t,e,i){let s=this.geometry.attributes.color.array,r=this.arrows.geometry.attributes.position.array,o=this.arrows.geometry.attributes.color.array,a=Gm(),l=[0,0,0];for(let c=0;c<this.count;c+=1){if(t(c,l),a(Math.hypot(l[0],l[1],l[2])/i,s,3*c),c%this.step!==0)continue;let u=18*(c/this.step);this.arrow(r,u,3*c,l,e);for(let f=0;f<18;f+=1)o[u+f]=s[3*c+f%3]}this.geometry.attributes.color.needsUpdate=!0,this.arrows.geometry.attributes.position.needsUpdate=!0,this.arrows.geometry.attributes.color.needsUpdate=!0}arrow(t,e,i,[s,r,o],a){let l=this.places,c=[l[i]+s*a,l[i+1]+r*a,l[i+2]+o*a],u=Math.abs(o)>Math.hypot(s,r)?[o,0,-s]:[-r,s,0];for(let f=0;f<3;f+=1){let h=[s,r,o][f]*a*Hm,d=u[f]*a*Hm*.5;t[e+f]=l[i+f],t[e+3+f]=c[f],t[e+6+f]=c[f],t[e+9+f]=c[f]-h+d,t[e+12+f]=c[f],t[e+15+f]=c[f]-h-d}}};var Wm={type:"change"},vf={type:"start"},$m={type:"end"},oh=new Ss,Xm=new hi,Sb=Math.cos(70*Ju.DEG2RAD),Mn=new Y,ei=2*Math.PI,Ce={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},xf=1e-6,ah=class extends ba{constructor(t,e=null){super(t,e),this.state=Ce.NONE,this.target=new Y,this.cursor=new Y,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Zs.ROTATE,MIDDLE:Zs.DOLLY,RIGHT:Zs.PAN},this.touches={ONE:Js.ROTATE,TWO:Js.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new Y,this._lastQuaternion=new zn,this._lastTargetPosition=new Y,this._quat=new zn().setFromUnitVectors(t.up,new Y(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new go,this._sphericalDelta=new go,this._scale=1,this._panOffset=new Y,this._rotateStart=new Jt,this._rotateEnd=new Jt,this._rotateDelta=new Jt,this._panStart=new Jt,this._panEnd=new Jt,this._panDelta=new Jt,this._dollyStart=new Jt,this._dollyEnd=new Jt,this._dollyDelta=new Jt,this._dollyDirection=new Y,this._mouse=new Jt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=bb.bind(this),this._onPointerDown=Mb.bind(this),this._onPointerUp=wb.bind(this),this._onContextMenu=Ib.bind(this),this._onMouseWheel=Ab.bind(this),this._onKeyDown=Cb.bind(this),this._onTouchStart=Rb.bind(this),this._onTouchMove=Pb.bind(this),this._onMouseDown=Tb.bind(this),this._onMouseMove=Eb.bind(this),this._interceptControlDown=Lb.bind(this),this._interceptControlUp=Db.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ce.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Wm),this.update(),this.state=Ce.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Mn.copy(e).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Ce.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ei:i>Math.PI&&(i-=ei),s<-Math.PI?s+=ei:s>Math.PI&&(s-=ei),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Mn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new Y(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new Y(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(oh.origin.copy(this.object.position),oh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(oh.direction))<Sb?this.object.lookAt(this.target):(Xm.setFromNormalAndCoplanarPoint(this.object.up,this.target),oh.intersectPlane(Xm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>xf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>xf||this._lastTargetPosition.distanceToSquared(this.target)>xf?(this.dispatchEvent(Wm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ei/60*this.autoRotateSpeed*t:ei/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Mn.setFromMatrixColumn(e,0),Mn.multiplyScalar(-t),this._panOffset.add(Mn)}_panUp(t,e){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(e,1):(Mn.setFromMatrixColumn(e,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(t),this._panOffset.add(Mn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Jt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function Mb(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function bb(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function wb(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent($m),this.state=Ce.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function Tb(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Zs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ce.DOLLY;break;case Zs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ce.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ce.ROTATE}break;case Zs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ce.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ce.PAN}break;default:this.state=Ce.NONE}this.state!==Ce.NONE&&this.dispatchEvent(vf)}function Eb(n){switch(this.state){case Ce.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ce.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ce.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Ab(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ce.NONE||(n.preventDefault(),this.dispatchEvent(vf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent($m))}function Cb(n){this.enabled!==!1&&this._handleKeyDown(n)}function Rb(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Js.ROTATE:if(this.enableRotate===!1){this.state=Ce.NONE;break}this._handleTouchStartRotate(n),this.state=Ce.TOUCH_ROTATE;break;case Js.PAN:if(this.enablePan===!1){this.state=Ce.NONE;break}this._handleTouchStartPan(n),this.state=Ce.TOUCH_PAN;break;default:this.state=Ce.NONE}break;case 2:switch(this.touches.TWO){case Js.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ce.TOUCH_DOLLY_PAN;break;case Js.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ce.TOUCH_DOLLY_ROTATE;break;default:this.state=Ce.NONE}break;default:this.state=Ce.NONE}this.state!==Ce.NONE&&this.dispatchEvent(vf)}function Pb(n){switch(this._trackPointer(n),this.state){case Ce.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ce.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ce.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ce.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ce.NONE}}function Ib(n){this.enabled!==!1&&n.preventDefault()}function Lb(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Db(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Nb=2e3,yf=class{constructor(t,e){this.canvas=k("canvas",{tabIndex:0,role:"img","aria-label":t}),this.element=k("div",{class:"view3d"},this.canvas),this.renderer=new th({canvas:this.canvas,antialias:!e,preserveDrawingBuffer:!0}),this.renderer.setPixelRatio(Math.min(devicePixelRatio,e?1:2)),this.scene=new oa,this.camera=new Zn(35,1,10,6e4),this.camera.up.set(0,0,1),this.sky=new _a(16777215,6710886,2.2),this.sky.position.set(0,0,1),this.sun=new ya(16777215,1.6),this.sun.position.set(1500,-2500,4e3),this.scene.add(this.sky,this.sun),this.controls=new ah(this.camera,this.canvas),this.controls.listenToKeyEvents(this.canvas),this.controls.addEventListener("change",()=>this.redraw()),this.canvas.addEventListener("keydown",i=>this.zoomByKey(i)),this.pending=new Set,this.redraw=$o(()=>this.draw()),this.themed=[],ss(()=>this.dress()),new ResizeObserver(()=>this.resize()).observe(this.element),this.dress()}dressed(t){this.themed.push(t),t(),this.redraw()}dress(){this.scene.background=new ce(ze("stage")),this.floor&&this.scene.remove(this.floor),this.floor=new Ma(Nb,20,ze("grid-strong"),ze("grid")),this.floor.rotation.x=Math.PI/2,this.scene.add(this.floor),this.themed.forEach(t=>t()),this.redraw()}lookAt(t,e){let i=new Y((t[0]+e[0])/2,(t[1]+e[1])/2,(t[2]+e[2])/2);this.radius=Math.max(Math.hypot(e[0]-t[0],e[1]-t[1],e[2]-t[2])/2,50),this.centre=i,this.home()}home(){let{aspect:t}=this.camera,e=this.camera.fov*Math.PI/360,i=this.radius/Math.sin(e)*(t<1?1/t:1)*.82;this.controls.target.copy(this.centre),this.camera.position.copy(this.centre).add(new Y(.72,-.95,.5).normalize().multiplyScalar(i)),this.controls.update(),this.redraw()}zoomByKey(t){let e={"+":.87,"=":.87,"-":1.15}[t.key];t.key==="Home"&&this.home(),e&&(this.camera.position.sub(this.controls.target).multiplyScalar(e).add(this.controls.target),this.controls.update(),t.preventDefault())}resize(){let{clientWidth:t,clientHeight:e}=this.element;if(t===0||e===0)return;let i=this.camera.aspect===1;this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),i&&this.centre&&this.home(),this.draw()}beforePicture(t){return()=>{this.pending.add(t),this.redraw()}}draw(){this.pending.forEach(t=>t()),this.pending.clear(),this.renderer.render(this.scene,this.camera)}onPick(t,e){let i=null;this.canvas.addEventListener("pointerdown",s=>{i=[s.clientX,s.clientY]}),this.canvas.addEventListener("pointerup",s=>{if(!i||Math.hypot(s.clientX-i[0],s.clientY-i[1])>4)return;let r=this.canvas.getBoundingClientRect(),o=new Jt((s.clientX-r.left)/r.width*2-1,1-(s.clientY-r.top)/r.height*2),a=new Sa,l=this.camera.position.distanceTo(this.controls.target);a.params.Points.threshold=9/r.height*2*l*Math.tan(this.camera.fov*Math.PI/360),a.setFromCamera(o,this.camera);let[c]=a.intersectObject(t()).sort((u,f)=>u.distanceToRay-f.distanceToRay);c&&e(c.index)})}toWindow([t,e,i]){let s=new Y(t,e,i).project(this.camera),r=this.canvas.getBoundingClientRect();return[r.left+(s.x+1)/2*r.width,r.top+(1-s.y)/2*r.height]}};function lh(n,t=!1){try{return new yf(n,t)}catch{return null}}function To({label:n,min:t,max:e,step:i,value:s,show:r,on:o,name:a}){let l=cr("slider"),c=k("output",{htmlFor:l}),u=k("input",{type:"range",id:l,min:t,max:e,step:i,name:a??l,oninput:()=>f(!0)}),f=h=>{let d=r(Number(u.value));c.textContent=d,u.setAttribute("aria-valuetext",d),h&&o(Number(u.value))};return u.value=s,f(!1),{element:k("div",{class:"slider"},k("label",{htmlFor:l,text:n}),c,u),input:u,set(h){Number(u.value)!==h&&(u.value=h,f(!1))},refresh:()=>f(!1)}}function Fa({label:n,value:t,on:e,name:i}){let s=cr("check"),r=k("input",{type:"checkbox",id:s,checked:t,name:i??s,onchange:()=>e(r.checked)});return k("div",{class:"check"},r,k("label",{htmlFor:s,text:n}))}function ch({label:n,options:t,value:e,on:i,name:s}){let r=cr("choice"),o=([a,l])=>{let c=cr("option"),u=k("input",{type:"radio",id:c,name:r,value:a,checked:a===e,onchange:()=>i(a)});return k("span",{class:"option"},u,k("label",{htmlFor:c,text:l}))};return k("fieldset",{class:"choice","data-name":s??r},k("legend",{text:n}),t.map(o))}function qm({label:n,options:t,value:e,on:i,name:s}){let r=cr("select"),o=k("select",{id:r,name:s??r,onchange:()=>i(o.value)},t.map(([a,l])=>k("option",{value:a,text:l})));return o.value=e,k("div",{class:"field"},k("label",{htmlFor:r,text:n}),o)}function Oa({label:n,on:t,name:e,type:i="search",placeholder:s=""}){let r=cr("search"),o=k("input",{type:i,id:r,placeholder:s,name:e??r,autocomplete:"off",spellcheck:!1,oninput:()=>t(o.value)});return k("div",{class:"field"},k("label",{htmlFor:r,text:n}),o)}var Mi=(n,t,e={})=>k("button",{type:"button",text:n,onclick:t,...e});function Zm({title:n,kind:t,verdict:e,tone:i,version:s,tasks:r,which:o}){let a=k("nav",{"aria-label":"Sections"});return{element:k("header",{class:"top"},k("div",{class:"brand"},k("p",{class:"kind"},k("span",{class:"word",text:"driftpost"}),` ${s} \xB7 ${t}`),k("h1",{title:n,text:n}),r&&k("p",{class:"tasks"},r.map((c,u)=>k("a",{href:`?task=${u+1}`,text:c,"aria-current":u===o&&"page"}))),e&&k("p",{class:`verdict ${i}`,text:e})),k("div",{class:"tools"},Mi("Light / dark",Vm,{class:"small",name:"theme"}),Mi("Print",()=>print(),{class:"small"})),a),link:c=>a.append(k("a",{href:`#${c.id}`,text:c.dataset.short}))}}function Zt(n,t,e,...i){return k("section",{id:n,"aria-labelledby":`${n}-title`,"data-short":e},k("h2",{id:`${n}-title`,text:t}),...i)}var se=(n,t,e,i,s="")=>k("div",{class:`figure ${s}`},k("dt",{text:n}),k("dd",{},k("span",{class:"value",text:t}),e&&t!==Fn&&k("span",{class:"unit",text:` ${e}`}),i&&k("span",{class:"note",text:i}))),Gn=(...n)=>k("dl",{class:"figures"},n),Ym=8,hh=n=>n.split("/").pop();function Oi(n,t){let e=r=>k("li",{class:`message ${t}`},k("span",{class:"code",text:r.code}),k("span",{class:"said",text:r.message}),r.file&&k("span",{class:"place",title:r.file,text:`${hh(r.file)}${r.line?`:${r.line}`:""}`}),r.help&&k("span",{class:"help",text:r.help})),i=n.slice(0,Ym).map(e),s=n.slice(Ym);return[k("ul",{class:"messages"},i),s.length>0&&Es(`${we(s.length,"more message")}`,()=>k("ul",{class:"messages"},s.slice(0,500).map(e),s.length>500&&k("li",{class:"message",text:`and ${s.length-500} more: see the JSON`})))]}function Es(n,t){let e=k("details",{},k("summary",{text:n}));return e.addEventListener("toggle",()=>{e.open&&e.children.length===1&&e.append(t())}),e}var Sf=n=>k("dl",{class:"facts"},n.map(([t,e])=>k("div",{},k("dt",{text:t}),k("dd",{text:e}))));function Hn(n,t){let e=i=>k("div",{class:"sign"},k("span",{class:"line"}),k("span",{text:`${i}: name, date, signature`}));return Zt("record","Record","Record",Sf([...n,["made with",`driftpost ${t}`]]),k("div",{class:"signatures"},e("Made by"),e("Reviewed by"),e("Released by")))}var br=400;function uh(n,t,e){let i=Math.min(n,br);if(i===t)return we(t,e);let s=[n<t&&"that match the search",n>br&&`the first ${ne(br)} in this order`].filter(Boolean);return`Printed: ${ne(i)} of ${we(t,e)}, ${s.join(", ")}.`}var Mf=40;function Ub(n){let{shared:t,files:e}=n.source;return e.flatMap(i=>i.rows.map(([s,r,o,a,l])=>({file:i.path,line:s,start:t[r],old:o,now:Array.isArray(a)?a.join(o):a,end:t[l]})))}function bf(n,t){return n.lines||(n.lines=n.view.source?Ub(n.view):[],n.lineAt=new Map(n.lines.map(e=>[`${e.file}:${e.line}`,e]))),n.lineAt.get(`${t.file}:${t.line}`)??null}var Jm=(n,t,e)=>k("code",{},n.start.trimStart(),t!==""&&k(e,{text:t}),n.end),Km=n=>n.now===null?k("code",{text:(n.start+n.old+n.end).trimStart()}):Jm(n,n.old,"del"),jm=n=>n.now===null?k("code",{class:"same",text:"stays as it is"}):Jm(n,n.now,"ins");function Qm(n){return n?k("div",{class:"pair"},k("div",{class:"side"},Km(n)),k("div",{class:"side"},jm(n))):k("p",{class:"calm",text:"its line is not on this page"})}function tg(n){let{view:t,data:e,course:i,correction:s}=n;bf(n,{});let r=new Map(e.motions.map(D=>[`${D.file}:${D.line}`,D])),o=new Map(i?i.points.motion.map((D,G)=>[D,G]):[]),a={text:"",bucket:"",least:0},l=0,c=[],u=k("div",{class:"diff-rows"}),f=k("p",{class:"status",role:"status"}),h=Mi("Previous",()=>E(-1),{class:"small"}),d=Mi("Next",()=>E(1),{class:"small"}),g=D=>r.get(`${D.file}:${D.line}`);function v(D){if(!D||D.status!=="compensated")return null;let G=o.get(D.index);if(a.bucket===""||G===void 0)return{size:D.max_correction_mm};let P=i.error(G,s.buckets[Number(a.bucket)].shares).map(W=>-W);return{size:xi(P),by:P}}let m=(D,G)=>(D.text??=`${D.file}:${D.line} ${D.start}${D.old}${D.end} ${D.now??""} ${G?.target??""} ${G?.routine??""}`.toLowerCase(),D.text);function p(){let D=a.text.trim().toLowerCase();c=n.lines.filter(G=>{let P=g(G);return a.least>0&&!((v(P)?.size??0)>=a.least)?!1:D?m(G,P).includes(D):!0}),l=0,y()}function y(){let D=Math.max(Math.ceil(c.length/Mf),1),G=c.slice(l*Mf,(l+1)*Mf);A(G);let P=n.lines.length,W=c.length===P?we(P,"line"):`${ne(c.length)} of ${we(P,"line")}`;f.textContent=D>1?`${W}, page ${ne(l+1)} of ${ne(D)}`:W,h.disabled=l===0,d.disabled=l>=D-1,V.hidden=D<2}function A(D){let G=null;u.replaceChildren(...D.flatMap(P=>{let W=P.file===G?[]:[k("p",{class:"diff-file"},k("span",{text:P.file}),R(P.file))];G=P.file;let O=v(g(P)),N=O?k("span",{class:"size",text:O.by?`${O.by.map(J=>At(J)).join(", ")} mm`:`${At(O.size)} mm`}):null;return[...W,k("div",{class:P.now===null?"diff-row same":"diff-row"},k("span",{class:"line",text:P.line}),k("div",{class:"side old"},Km(P)),k("div",{class:"side new"},jm(P),N))]})),D.length===0&&u.append(k("p",{class:"empty",text:"no line matches"}))}let M=new Map(t.source.files.map(D=>[D.path,D.result])),R=D=>M.get(D)?k("span",{class:"result",text:` \u2192 ${M.get(D)}`}):null;function E(D){l+=D,y()}let _=D=>{Object.assign(a,D),p()},T=D=>`${D.index}: ${D.from_min} to ${D.to_min??"\u221E"} min`,V=k("div",{class:"pager"},h,d),F=k("div",{class:"bar"},Oa({label:"Motion, routine or text",name:"source-search",on:D=>_({text:D})}),i&&s.inBuckets&&qm({label:"Correction of bucket",name:"source-bucket",value:"",options:[["","largest of all"],...s.buckets.map((D,G)=>[String(G),T(D)])],on:D=>_({bucket:D})}),Oa({label:"At least, mm",name:"source-least",type:"number",on:D=>_({least:Number(D)||0})}),f,V);addEventListener("beforeprint",()=>{A(c.slice(0,br)),f.textContent=uh(c.length,n.lines.length,"line")}),addEventListener("afterprint",y),p(),tl(n.lines.length,D=>m(n.lines[D],g(n.lines[D])));let L=t.source.files.reduce((D,G)=>D+G.left_out,0);return Zt("source","Source, line by line","Source",F,k("div",{class:"diff",tabIndex:0,role:"group","aria-label":"Source before and after"},u),L>0&&k("p",{class:"notice",text:`${we(L,"more changed line")} are not on this page; --diff FILE writes all.`}),Fb(t.source.files))}function Fb(n){let t=n.flatMap(i=>i.added.map(s=>({path:i.result??i.path,...s})));if(t.length===0)return null;let e=t.reduce((i,s)=>i+s.lines,0);return Es(`${we(e,"line")} added in ${we(t.length,"place")}: comment block, data and routines whose names begin with tc`,()=>k("div",{},t.slice(0,60).map(i=>k("div",{class:"added"},k("p",{class:"diff-file",text:`${i.path}, after line ${i.after} of the source: ${we(i.lines,"line")}`}),k("pre",{tabIndex:0,text:i.text.join(`
`)+(i.lines>i.text.length?`
\u2026 ${we(i.lines-i.text.length,"more line")}`:"")})))))}var fh=(n,t=4)=>n.map(e=>At(e,t)).join(", ");function eg(n){let{course:t,correction:e,state:i,motions:s}=n,r=k("div",{class:"card-body"}),o=k("div",{class:"card","aria-live":"polite",id:"target"},k("h3",{text:"Target"}),r),a=()=>{let l=i.point;if(l===null)return r.replaceChildren(k("p",{class:"calm",text:"Click on a target, or choose one in the table of motions."}));let c=s.get(t.points.motion[l]),u=c?wf(c,t.points.value[l]):`target ${l+1}`;o.querySelector("h3").textContent=`Target ${u}`;let f=t.at(i.t),h=t.error(l,f),d=t.error(l,e.leftShares(i.t)),g=t.error(l,e.correctedShares(i.t)).map(y=>-y),v=(y,A,M)=>k("div",{},k("dt",{text:y}),k("dd",{text:A},M&&k("span",{class:"note",text:M}))),m=e.bucketAt(i.t),p=c?.status==="compensated";r.replaceChildren(k("dl",{class:"numbers"},v("in the base",`${fh(t.position(l),3)} mm`),v("joints",`${t.joints(l).map(y=>Qa(y,2)).join(", ")}\xB0`),v("at",`${ye(t.from+i.t)} ${t.unit}${m?`, bucket ${m.index}`:""}`),v("uncorrected",`${At(xi(h))} mm`,fh(h)),p&&v("corrected",e.inBuckets?`${At(xi(d))} mm`:`\u2264 ${At(c.after_mm)} mm`,e.inBuckets?fh(d):"at any minute"),p&&v("correction",`${At(xi(g))} mm`,fh(g)),c&&v("worst of all minutes",`${At(c.before_mm)} mm`,p?`${At(c.after_mm)} mm corrected`:c.status)),c&&k("p",{class:"where"},`${c.file}:${c.line}`,c.routine&&` in ${c.routine}`),c&&Qm(bf(n,c)))};return i.on("t point",a),a(),o}function wf(n,t=0){let e=n.target??`line ${n.line}`;return t>0?`${e} (value ${t+1})`:e}var ng=16,sg=500,Tf=200,Ob=4e3,ig=n=>Math.round(sg**(n/Tf)),Bb=n=>Math.round(Math.log(n)/Math.log(sg)*Tf);function rg(n){let{course:t,state:e,view:i}=n,s=il(i.robot),r=`${i.robot.name}: the arm, its drift enlarged`,o=lh(`The arm in 3-D with ${t.count} targets. Arrow keys with Shift turn it, plus and minus zoom, Home looks from the start again.`,t.count>Ob),a=eg(n),l=k("div",{class:"panel"},Vb(n),Gb(n),Hb(n),Wb(n,s));if(!o)return Zt("arm",r,"Arm",k("p",{class:"notice",text:"This browser draws no 3-D (WebGL is off)."}),k("div",{class:"stage"},l),a);let c=new Mr(s,{thickness:30,transparent:!0,opacity:.32,axes:!1}),u=new Mr(s,{thickness:24,transparent:!1,opacity:1,axes:!0}),f=new wo(t.points.p_mm);o.scene.add(c.group,u.group,f.group),o.dressed(()=>{c.paint(ze("nominal"),ze("nominal")),u.paint(ze("arm"),ze("arm-joint")),f.paint({path:ze("path"),ring:ze("accent")})});let h=Math.max(n.data.worst_before_mm||Xb(t),1e-6),d=new Float64Array(3),g=!0,v=o.beforePicture(()=>{let{t:A,times:M,corrected:R,point:E}=e;if(g){let _=R?n.correction.leftShares(A):t.at(A);f.show((T,V)=>t.error(T,_,V),M,h),g=!1}f.arrows.visible=e.arrows!==!1,f.path.visible=e.path!==!1,f.mark(E),p()}),m=k("p",{class:"hud",role:"status"});function p(){let A=e.joints??t.joints(0),M=t.tool(e.point??0),R=t.deviation(e.point??0,e.t),E=c.pose(A,M),_=u.pose(A,M,R);u.pose(A,M,R,e.times);let T=Math.hypot(..._.map((L,D)=>L-E[D])),V=t.isByTarget&&A.some((L,D)=>L!==t.joints(e.point??0)[D]),F=t.hasModel&&!t.model?"":`, off by ${At(T)} mm${V?" with the deformation at the target":""}`;m.textContent=`TCP ${E.map(L=>L.toFixed(1)).join(", ")} mm${F}`}let y=()=>{g=!0,v()};return e.on("t times corrected",y),e.on("point arrows path joints",v),ss(y),e.on("point",()=>{e.point!==null&&e.set({joints:t.joints(e.point)})}),o.onPick(()=>f.dots,A=>e.set({point:A})),zb(o,t),v(),o.canvas.windowPlace=A=>o.toWindow(t.position(A)),Zt("arm",r,"Arm",k("div",{class:"stage"},k("div",{class:"screen"},o.element,m,$b(h,e)),l),kb(t),a)}function kb(n){if(!n.hasModel)return null;let t=n.model?n.isByTarget?"The arm is drawn with the deformation table and all that the identified model adds at the chosen target and minute: load, direction and joints of that target included. Jogged away from it, it keeps that deformation: what the model would give there is not on the page.":"The arm is drawn with the deformation table and all that the identified model adds at the minute; it is the same wherever the arm stands.":"Errors at the targets hold all that the identified model adds. Of so many targets the page holds no deformation for each: the arm is drawn with the offsets of the deformation table alone.";return k("p",{class:"notice","data-name":"model-notice",text:t})}function zb(n,t){let e=[-250,-250,0],i=[250,250,700];for(let s=0;s<t.count;s+=1)t.position(s).forEach((r,o)=>{e[o]=Math.min(e[o],r),i[o]=Math.max(i[o],r)});n.lookAt(e,i)}function Vb({course:n,state:t}){let e=n.end>20?1:n.end/100,i=To({label:n.byTemperature?"Temperature":"Warm-up minute",name:"minute",min:0,max:n.end,step:e,value:t.t,show:c=>`${ye(n.from+c)} ${n.unit}`,on:c=>t.set({t:c})});t.on("t",()=>i.set(t.t));let s=null,r=Mi("Play",()=>s===null?a():o(),{name:"play",class:"small"}),o=()=>{s=null,r.textContent="Play"};function a(){let c=t.t>=n.end?0:t.t;s=performance.now()-c/n.end*ng*1e3,r.textContent="Pause",requestAnimationFrame(l)}function l(c){if(s===null)return;let u=(c-s)/(ng*1e3)*n.end;t.set({t:Math.min(e===1?Math.round(u):u,n.end)}),u>=n.end?o():requestAnimationFrame(l)}return k("div",{class:"row"},i.element,r)}function Gb({state:n}){return To({label:"Deformation enlarged",name:"times",min:0,max:Tf,step:1,value:Bb(n.times),show:t=>`${ig(t)} \xD7`,on:t=>n.set({times:ig(t)})}).element}function Hb({state:n}){return k("div",{class:"shows"},ch({label:"Errors",name:"corrected",options:[["no","uncorrected"],["yes","corrected"]],value:"no",on:t=>n.set({corrected:t==="yes"})}),k("div",{class:"checks"},Fa({label:"arrows",name:"arrows",value:!0,on:t=>n.set({arrows:t})}),Fa({label:"path",name:"path",value:!0,on:t=>n.set({path:t})})))}function Wb({course:n,state:t},e){let i=e.joints.map((s,r)=>{let[o,a]=s.range??[-360,360];return To({label:`J${r+1}`,name:`joint-${r+1}`,min:o,max:a,step:.1,value:(t.joints??n.joints(0))[r],show:l=>`${Qa(l,1)}\xB0`,on:l=>{let c=[...t.joints??n.joints(0)];c[r]=l,t.set({joints:c})}})});return t.on("joints",()=>i.forEach((s,r)=>s.set(t.joints[r]))),k("fieldset",{class:"jog"},k("legend",{text:"Jog"}),i.map(s=>s.element),Mi("Back to the target",()=>t.set({joints:n.joints(t.point??0)}),{class:"small"}))}function Xb(n){let t=n.at(n.end);return Array.from({length:n.count},(e,i)=>Math.hypot(...n.error(i,t))).reduce((e,i)=>Math.max(e,i),0)}function $b(n,t){let e=k("span",{text:`${At(n,3)} mm`});return k("p",{class:"scale"},k("span",{text:"0"}),k("span",{class:"ramp","aria-hidden":"true"}),e)}var qb="uplot",Yb="u-hz",Zb="u-vt",Jb="u-title",Kb="u-wrap",jb="u-under",Qb="u-over",tw="u-axis",Er="u-off",ew="u-select",nw="u-cursor-x",iw="u-cursor-y",sw="u-cursor-pt",rw="u-legend",ow="u-live",aw="u-inline",lw="u-series",cw="u-marker",og="u-label",hw="u-value",ka="width",za="height";var ag="bottom",Eo="left",Ef="right",Hf="#000",lg=Hf+"0",Af="mousemove",cg="mousedown",Cf="mouseup",hg="mouseenter",ug="mouseleave",fg="dblclick",uw="resize",fw="scroll",dg="change",_h="dppxchange",Wf="--",Do=typeof window<"u",Df=Do?document:null,Co=Do?window:null,dw=Do?navigator:null,Re,dh;function Nf(){let n=devicePixelRatio;Re!=n&&(Re=n,dh&&Ff(dg,dh,Nf),dh=matchMedia(`(min-resolution: ${Re-.001}dppx) and (max-resolution: ${Re+.001}dppx)`),Ar(dg,dh,Nf),Co.dispatchEvent(new CustomEvent(_h)))}function di(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Uf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ze(n,t,e){n.style[t]=e+"px"}function Bi(n,t,e,i){let s=Df.createElement(n);return t!=null&&di(s,t),e?.insertBefore(s,i),s}function bi(n,t){return Bi("div",n,t)}var pg=new WeakMap;function rs(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=pg.get(n);r!=o&&(n.style.transform=r,pg.set(n,r),t<0||e<0||t>i||e>s?di(n,Er):Uf(n,Er))}var mg=new WeakMap;function gg(n,t,e){let i=t+e,s=mg.get(n);i!=s&&(mg.set(n,i),n.style.background=t,n.style.borderColor=e)}var _g=new WeakMap;function xg(n,t,e,i){let s=t+""+e,r=_g.get(n);s!=r&&(_g.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Xf={passive:!0},pw={...Xf,capture:!0};function Ar(n,t,e,i){t.addEventListener(n,e,i?pw:Xf)}function Ff(n,t,e,i){t.removeEventListener(n,e,Xf)}Do&&Nf();function ki(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:pi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function $g(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var qg=n=>n!=null,Yg=n=>n!=null&&n>0,yh=$g(qg),mw=$g(Yg);function gw(n,t,e,i=0,s=!1){let r=s?mw:yh,o=s?Yg:qg;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ve,l??-Ve]}function Sh(n,t,e,i){let s=Sg(n),r=Sg(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?As:Zg,a=s==1?pi:wi,l=r==1?wi:pi,c=a(o(wn(n))),u=l(o(wn(t))),f=Ro(e,c),h=Ro(e,u);return e==10&&(c<0&&(f=Ge(f,-c)),u<0&&(h=Ge(h,-u))),i||e==2?(n=f*s,t=h*r):(n=Qg(n,f),t=Mh(t,h)),[n,t]}function $f(n,t,e,i){let s=Sh(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var qf=.1,vg={mode:3,pad:qf},Ga={pad:0,soft:null,mode:0},_w={min:Ga,max:Ga};function xh(n,t,e,i){return bh(e)?yg(n,t,e):(Ga.pad=e,Ga.soft=i?0:null,Ga.mode=i?3:0,yg(n,t,_w))}function Ee(n,t){return n??t}function xw(n,t,e){for(t=Ee(t,0),e=Ee(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function yg(n,t,e){let i=e.min,s=e.max,r=Ee(i.pad,0),o=Ee(s.pad,0),a=Ee(i.hard,-Ve),l=Ee(s.hard,Ve),c=Ee(i.soft,Ve),u=Ee(s.soft,-Ve),f=Ee(i.mode,0),h=Ee(s.mode,0),d=t-n,g=As(d),v=Qn(wn(n),wn(t)),m=As(v),p=wn(m-g);(d<1e-24||p>10)&&(d=0,(n==0||t==0)&&(d=1e-24,f==2&&c!=Ve&&(r=0),h==2&&u!=-Ve&&(o=0)));let y=d||v||1e3,A=As(y),M=Ro(10,pi(A)),R=y*(d==0?n==0?.1:1:r),E=Ge(Qg(n-R,M/10),24),_=n>=c&&(f==1||f==3&&E<=c||f==2&&E>=c)?c:Ve,T=Qn(a,E<_&&n>=_?_:zi(_,E)),V=y*(d==0?t==0?.1:1:o),F=Ge(Mh(t+V,M/10),24),L=t<=u&&(h==1||h==3&&F>=u||h==2&&F<=u)?u:-Ve,D=zi(l,F>L&&t<=L?L:Qn(L,F));return T==D&&T==0&&(D=100),[T,D]}var vw=new Intl.NumberFormat(Do?dw.language:"en-US"),Yf=n=>vw.format(n),mi=Math,gh=mi.PI,wn=mi.abs,pi=mi.floor,bn=mi.round,wi=mi.ceil,zi=mi.min,Qn=mi.max,Ro=mi.pow,Sg=mi.sign,As=mi.log10,Zg=mi.log2,yw=(n,t=1)=>mi.sinh(n)*t,Rf=(n,t=1)=>mi.asinh(n/t),Ve=1/0;function Mg(n){return(As((n^n>>31)-(n>>31))|0)+1}function Of(n,t,e){return zi(Qn(n,t),e)}function Jg(n){return typeof n=="function"}function Me(n){return Jg(n)?n:()=>n}var Sw=()=>{},Kg=n=>n,jg=(n,t)=>t,Mw=n=>null,bg=n=>!0,wg=(n,t)=>n==t,bw=/\.\d*?(?=9{6,}|0{6,})/gm,Cr=n=>{if(e0(n)||tr.has(n))return n;let t=`${n}`,e=t.match(bw);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Cr(s)}e${r}`}return Ge(n,i)};function wr(n,t){return Cr(Ge(Cr(n/t))*t)}function Mh(n,t){return Cr(wi(Cr(n/t))*t)}function Qg(n,t){return Cr(pi(Cr(n/t))*t)}function Ge(n,t=0){if(e0(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return bn(i)/e}var tr=new Map;function t0(n){return((""+n).split(".")[1]||"").length}function Wa(n,t,e,i){let s=[],r=i.map(t0);for(let o=t;o<e;o++){let a=wn(o),l=Ge(Ro(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Ge(u,f);s.push(h),tr.set(h,f)}}return s}var Ha={},Zf=[],Po=[null,null],Qs=Array.isArray,e0=Number.isInteger,ww=n=>n===void 0;function Tg(n){return typeof n=="string"}function bh(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function Tw(n){return n!=null&&typeof n=="object"}var Ew=Object.getPrototypeOf(Uint8Array),n0="__proto__";function Io(n,t=bh){let e;if(Qs(n)){let i=n.find(s=>s!=null);if(Qs(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Io(n[s],t)}else e=n.slice()}else if(n instanceof Ew)e=n.slice();else if(t(n)){e={};for(let i in n)i!=n0&&(e[i]=Io(n[i],t))}else e=n;return e}function gn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=n0&&(bh(n[s])?gn(n[s],Io(i[s])):n[s]=Io(i[s]))}return n}var Aw=0,Cw=1,Rw=2;function Pw(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function Iw(n,t){if(Nw(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Uw(o[0])||(o=Dw(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=t?t[o][c]:Cw,d=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?h!=Aw&&(f[m]=v,h==Rw&&d.push(m)):f[m]=v}Pw(f,d,s),i.push(f)}}return i}var Lw=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Dw(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Nw(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Uw(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Qn(1,pi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var i0=["January","February","March","April","May","June","July","August","September","October","November","December"],s0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function r0(n){return n.slice(0,3)}var Fw=s0.map(r0),Ow=i0.map(r0),Bw={MMMM:i0,MMM:Ow,WWWW:s0,WWW:Fw};function Ba(n){return(n<10?"0":"")+n}function kw(n){return(n<10?"00":n<100?"0":"")+n}var zw={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Ba(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ba(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Ba(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ba(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ba(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>kw(n.getMilliseconds())};function Jf(n,t){t=t||Bw;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?zw[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Vw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Gw(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==Vw?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var o0=n=>n%1==0,vh=[1,2,2.5,5],Hw=Wa(10,-32,0,vh),a0=Wa(10,0,32,vh),Ww=a0.filter(o0),Tr=Hw.concat(a0),Kf=`
`,l0="{YYYY}",Eg=Kf+l0,c0="{M}/{D}",Va=Kf+c0,ph=Va+"/{YY}",h0="{aa}",Xw="{h}:{mm}",Ao=Xw+h0,Ag=Kf+Ao,Cg=":{ss}",Ie=null;function u0(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Wa(10,0,3,vh).filter(o0):Wa(10,-3,0,vh)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,l0,Ie,Ie,Ie,Ie,Ie,Ie,1],[s*28,"{MMM}",Eg,Ie,Ie,Ie,Ie,Ie,1],[s,c0,Eg,Ie,Ie,Ie,Ie,Ie,1],[i,"{h}"+h0,ph,Ie,Va,Ie,Ie,Ie,1],[e,Ao,ph,Ie,Va,Ie,Ie,Ie,1],[t,Cg,ph+" "+Ao,Ie,Va+" "+Ao,Ie,Ag,Ie,1],[n,Cg+".{fff}",ph+" "+Ao,Ie,Va+" "+Ao,Ie,Ag,Ie,1]];function u(f){return(h,d,g,v,m,p)=>{let y=[],A=m>=o,M=m>=r&&m<o,R=f(g),E=Ge(R*n,3),_=Pf(R.getFullYear(),A?0:R.getMonth(),M||A?1:R.getDate()),T=Ge(_*n,3);if(M||A){let V=M?m/r:0,F=A?m/o:0,L=E==T?E:Ge(Pf(_.getFullYear()+F,_.getMonth()+V,1)*n,3),D=new Date(bn(L/n)),G=D.getFullYear(),P=D.getMonth();for(let W=0;L<=v;W++){let O=Pf(G+F*W,P+V*W,1),N=O-f(Ge(O*n,3));L=Ge((+O+N)*n,3),L<=v&&y.push(L)}}else{let V=m>=s?s:m,F=pi(g)-pi(E),L=T+F+Mh(E-T,V);y.push(L);let D=f(L),G=D.getHours()+D.getMinutes()/e+D.getSeconds()/i,P=m/i,W=h.axes[d]._space,O=p/W;for(;L=Ge(L+m,n==1?0:3),!(L>v);)if(P>1){let N=pi(Ge(G+P,6))%24,Z=f(L).getHours()-N;Z>1&&(Z=-1),L-=Z*i,G=(G+P)%24;let nt=y[y.length-1];Ge((L-nt)/m,3)*O>=.7&&y.push(L)}else y.push(L)}return y}}return[l,c,u]}var[$w,qw,Yw]=u0(1),[Zw,Jw,Kw]=u0(.001);Wa(2,-53,53,[1]);function Rg(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Pg(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,f,h,d;return i.map(g=>{let v=n(g),m=v.getFullYear(),p=v.getMonth(),y=v.getDate(),A=v.getHours(),M=v.getMinutes(),R=v.getSeconds(),E=m!=l&&a[2]||p!=c&&a[3]||y!=u&&a[4]||A!=f&&a[5]||M!=h&&a[6]||R!=d&&a[7]||a[1];return l=m,c=p,u=y,f=A,h=M,d=R,E(v)})}}function jw(n,t){let e=Jf(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Pf(n,t,e){return new Date(n,t,e)}function Ig(n,t){return t(n)}var Qw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Lg(n,t){return(e,i,s,r)=>r==null?Wf:t(n(i))}function tT(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function eT(n,t){return n.series[t].fill(n,t)}var nT={show:!0,live:!0,isolate:!1,mount:Sw,markers:{show:!0,width:2,stroke:tT,fill:eT,dash:"solid"},idx:null,idxs:null,values:[]};function iT(n,t){let e=n.cursor.points,i=bi(),s=e.size(n,t);Ze(i,ka,s),Ze(i,za,s);let r=s/-2;Ze(i,"marginLeft",r),Ze(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ze(i,"borderWidth",o),i}function sT(n,t){let e=n.series[t].points;return e._fill||e._stroke}function rT(n,t){let e=n.series[t].points;return e._stroke||e._fill}function oT(n,t){return n.series[t].points.size}var If=[0,0];function aT(n,t,e){return If[0]=t,If[1]=e,If}function mh(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Lf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var lT={show:!0,x:!0,y:!0,lock:!1,move:aT,points:{one:!1,show:iT,size:oT,width:0,stroke:rT,fill:sT},bind:{mousedown:mh,mouseup:mh,click:mh,dblclick:mh,mousemove:Lf,mouseleave:Lf,mouseenter:Lf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},f0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},jf=gn({},f0,{filter:jg}),d0=gn({},jf,{size:10}),p0=gn({},f0,{show:!1}),Qf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',m0="bold "+Qf,g0=1.5,Dg={show:!0,scale:"x",stroke:Hf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:m0,side:2,grid:jf,ticks:d0,border:p0,font:Qf,lineGap:g0,rotate:0},cT="Value",hT="Time",Ng={show:!0,scale:"x",auto:!1,sorted:1,min:Ve,max:-Ve,idxs:[]};function uT(n,t,e,i,s){return t.map(r=>r==null?"":Yf(r))}function fT(n,t,e,i,s,r,o){let a=[],l=tr.get(s)||0;e=o?e:Ge(Mh(e,s),l);for(let c=e;c<=i;c=Ge(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Bf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?As:Zg,u=pi(c(e));s=Ro(l,u),l==10&&(s=Tr[ki(s,Tr)]);let f=e,h=s*l;l==10&&(h=Tr[ki(h,Tr)]);do a.push(f),f=f+s,l==10&&!tr.has(f)&&(f=Ge(f,tr.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=Tr[ki(h,Tr)]));while(f<=i);return a}function dT(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Bf(n,t,Qn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Bf(n,t,Qn(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(u,c)}var _0=/./,pT=/[12357]/,mT=/[125]/,Ug=/1/,kf=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function gT(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?_0:l(7,o)-u>=c?pT:l(5,o)-u>=c?mT:Ug;if(f==Ug){let h=wn(l(1,o)-u);if(h<c)return kf(t.slice().reverse(),a.distr,f,wi(c/h)).reverse()}return kf(t,a.distr,f,1)}function _T(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=wn(l(1,o)-l(2,o));return c<a?kf(t.slice().reverse(),3,_0,wi(a/c)).reverse():t}function xT(n,t,e,i){return i==null?Wf:t==null?"":Yf(t)}var Fg={show:!0,scale:"y",stroke:Hf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:m0,side:3,grid:jf,ticks:d0,border:p0,font:Qf,lineGap:g0,rotate:0};function vT(n,t){let e=3+(n||1)*2;return Ge(e*t,3)}function yT(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=wn(o-r),l=n.series[t],c=a/(l.points.space*Re);return i[1]-i[0]<=c}var Og={scale:null,auto:!0,sorted:0,min:Ve,max:-Ve},x0=(n,t,e,i,s)=>s,Bg={show:!0,auto:!0,sorted:0,gaps:x0,alpha:1,facets:[gn({},Og,{scale:"x"}),gn({},Og,{scale:"y"})]},kg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:x0,alpha:1,points:{show:yT,filter:null},values:null,min:Ve,max:-Ve,idxs:[],path:null,clip:null};function ST(n,t,e,i,s){return e/10}var v0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},MT=gn({},v0,{time:!1,ori:1}),zg={};function y0(n,t){let e=zg[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(zg[n]=e)),e}var Lo=1,zf=2;function Rr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,g=a.width,v=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?e(s,l,c,u,f,m,p,h,d,g,v,Th,No,Ah,M0,w0):e(s,l,c,u,f,p,m,d,h,v,g,Eh,Uo,nd,b0,T0)}function td(n,t){let e=0,i=0,s=Ee(n.bands,Zf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function bT(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Cs(n,t,e,i,s,r){return Rr(n,t,(o,a,l,c,u,f,h,d,g,v,m)=>{let p=o.pxRound,y=c.dir*(c.ori==0?1:-1),A=c.ori==0?No:Uo,M,R;y==1?(M=e,R=i):(M=i,R=e);let E=p(f(a[M],c,v,d)),_=p(h(l[M],u,m,g)),T=p(f(a[R],c,v,d)),V=p(h(r==1?u.max:u.min,u,m,g)),F=new Path2D(s);return A(F,T,V),A(F,E,V),A(F,E,_),F})}function wh(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Ah:nd,l=e;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function wT(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function ed(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let d=r(n[f]),g=h==f?d:r(n[h]),v=f-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let p=h+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=d&&a.push([d,g])}return a}function Vg(n){return n==0?Kg:n==1?bn:t=>wr(t,n)}function S0(n){let t=n==0?Th:Eh,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=zi(c,a/2,l/2),u=zi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Th=(n,t,e)=>{n.moveTo(t,e)},Eh=(n,t,e)=>{n.moveTo(e,t)},No=(n,t,e)=>{n.lineTo(t,e)},Uo=(n,t,e)=>{n.lineTo(e,t)},Ah=S0(0),nd=S0(1),M0=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},b0=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},w0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},T0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function E0(n){return(t,e,i,s,r)=>Rr(t,e,(o,a,l,c,u,f,h,d,g,v,m)=>{let{pxRound:p,points:y}=o,A,M;c.ori==0?(A=Th,M=M0):(A=Eh,M=b0);let R=Ge(y.width*Re,3),E=(y.size-y.width)/2*Re,_=Ge(E*2,3),T=new Path2D,V=new Path2D,{left:F,top:L,width:D,height:G}=t.bbox;Ah(V,F-_,L-_,D+_*2,G+_*2);let P=W=>{if(l[W]!=null){let O=p(f(a[W],c,v,d)),N=p(h(l[W],u,m,g));A(T,O+E,N),M(T,O,N,E,0,gh*2)}};if(r)r.forEach(P);else for(let W=i;W<=s;W++)P(W);return{stroke:R>0?T:null,fill:T,clip:V,flags:Lo|zf}})}function A0(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var TT=A0(No),ET=A0(Uo);function C0(n){let t=Ee(n?.alignGaps,0);return(e,i,s,r)=>Rr(e,i,(o,a,l,c,u,f,h,d,g,v,m)=>{[s,r]=yh(l,s,r);let p=o.pxRound,y=G=>p(f(G,c,v,d)),A=G=>p(h(G,u,m,g)),M,R;c.ori==0?(M=No,R=TT):(M=Uo,R=ET);let E=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lo},T=_.stroke,V=!1;if(r-s>=v*4){let G=ut=>e.posToVal(ut,c.key,!0),P=null,W=null,O,N,J,X=y(a[E==1?s:r]),Z=y(a[s]),nt=y(a[r]),ft=G(E==1?Z+1:nt-1);for(let ut=E==1?s:r;ut>=s&&ut<=r;ut+=E){let et=a[ut],xt=(E==1?et<ft:et>ft)?X:y(et),Ct=l[ut];xt==X?Ct!=null?(N=Ct,P==null?(M(T,xt,A(N)),O=P=W=N):N<P?P=N:N>W&&(W=N)):Ct===null&&(V=!0):(P!=null&&R(T,X,A(P),A(W),A(O),A(N)),Ct!=null?(N=Ct,M(T,xt,A(N)),P=W=O=N):(P=W=null,Ct===null&&(V=!0)),X=xt,ft=G(X+E))}P!=null&&P!=W&&J!=X&&R(T,X,A(P),A(W),A(O),A(N))}else for(let G=E==1?s:r;G>=s&&G<=r;G+=E){let P=l[G];P===null?V=!0:P!=null&&M(T,y(a[G]),A(P))}let[L,D]=td(e,i);if(o.fill!=null||L!=0){let G=_.fill=new Path2D(T),P=o.fillTo(e,i,o.min,o.max,L),W=A(P),O=y(a[s]),N=y(a[r]);E==-1&&([N,O]=[O,N]),M(G,N,W),M(G,O,W)}if(!o.spanGaps){let G=[];V&&G.push(...ed(a,l,s,r,E,y,t)),_.gaps=G=o.gaps(e,i,s,r,G),_.clip=wh(G,c.ori,d,g,v,m)}return D!=0&&(_.band=D==2?[Cs(e,i,s,r,T,-1),Cs(e,i,s,r,T,1)]:Cs(e,i,s,r,T,D)),_})}function AT(n){let t=Ee(n.align,1),e=Ee(n.ascDesc,!1),i=Ee(n.alignGaps,0),s=Ee(n.extend,!1);return(r,o,a,l)=>Rr(r,o,(c,u,f,h,d,g,v,m,p,y,A)=>{[a,l]=yh(f,a,l);let M=c.pxRound,{left:R,width:E}=r.bbox,_=Z=>M(g(Z,h,y,m)),T=Z=>M(v(Z,d,A,p)),V=h.ori==0?No:Uo,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lo},L=F.stroke,D=h.dir*(h.ori==0?1:-1),G=T(f[D==1?a:l]),P=_(u[D==1?a:l]),W=P,O=P;s&&t==-1&&(O=R,V(L,O,G)),V(L,P,G);for(let Z=D==1?a:l;Z>=a&&Z<=l;Z+=D){let nt=f[Z];if(nt==null)continue;let ft=_(u[Z]),ut=T(nt);t==1?V(L,ft,G):V(L,W,ut),V(L,ft,ut),G=ut,W=ft}let N=W;s&&t==1&&(N=R+E,V(L,N,G));let[J,X]=td(r,o);if(c.fill!=null||J!=0){let Z=F.fill=new Path2D(L),nt=c.fillTo(r,o,c.min,c.max,J),ft=T(nt);V(Z,N,ft),V(Z,O,ft)}if(!c.spanGaps){let Z=[];Z.push(...ed(u,f,a,l,D,_,i));let nt=c.width*Re/2,ft=e||t==1?nt:-nt,ut=e||t==-1?-nt:nt;Z.forEach(et=>{et[0]+=ft,et[1]+=ut}),F.gaps=Z=c.gaps(r,o,a,l,Z),F.clip=wh(Z,h.ori,m,p,y,A)}return X!=0&&(F.band=X==2?[Cs(r,o,a,l,L,-1),Cs(r,o,a,l,L,1)]:Cs(r,o,a,l,L,X)),F})}function Gg(n,t,e,i,s,r,o=Ve){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=wn(n[l]-n[a]);u<c&&(c=u,o=wn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function CT(n){n=n||Ha;let t=Ee(n.size,[.6,Ve,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Me(s),o=1-t[0],a=Ee(t[1],Ve),l=Ee(t[2],1),c=Ee(n.disp,Ha),u=Ee(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,g,v,m)=>Rr(d,g,(p,y,A,M,R,E,_,T,V,F,L)=>{let D=p.pxRound,G=e,P=i*Re,W=a*Re,O=l*Re,N,J;M.ori==0?[N,J]=r(d,g):[J,N]=r(d,g);let X=M.dir*(M.ori==0?1:-1),Z=M.ori==0?Ah:nd,nt=M.ori==0?u:(Pt,Yt,le,bt,Be,Vt,$t)=>{u(Pt,Yt,le,Be,bt,$t,Vt)},ft=Ee(d.bands,Zf).find(Pt=>Pt.series[0]==g),ut=ft!=null?ft.dir:0,et=p.fillTo(d,g,p.min,p.max,ut),mt=D(_(et,R,L,V)),xt,Ct,Mt,Wt=F,ae=D(p.width*Re),Gt=!1,pe=null,ue=null,re=null,Je=null;f!=null&&(ae==0||h!=null)&&(Gt=!0,pe=f.values(d,g,v,m),ue=new Map,new Set(pe).forEach(Pt=>{Pt!=null&&ue.set(Pt,new Path2D)}),ae>0&&(re=h.values(d,g,v,m),Je=new Map,new Set(re).forEach(Pt=>{Pt!=null&&Je.set(Pt,new Path2D)})));let{x0:He,size:cn}=c;if(He!=null&&cn!=null){G=1,y=He.values(d,g,v,m),He.unit==2&&(y=y.map(le=>d.posToVal(T+le*F,M.key,!0)));let Pt=cn.values(d,g,v,m);cn.unit==2?Ct=Pt[0]*F:Ct=E(Pt[0],M,F,T)-E(0,M,F,T),Wt=Gg(y,A,E,M,F,T,Wt),Mt=Wt-Ct+P}else Wt=Gg(y,A,E,M,F,T,Wt),Mt=Wt*o+P,Ct=Wt-Mt;Mt<1&&(Mt=0),ae>=Ct/2&&(ae=0),Mt<5&&(D=Kg);let Ue=Mt>0,Tn=Wt-Mt-(Ue?ae:0);Ct=D(Of(Tn,O,W)),xt=(G==0?Ct/2:G==X?0:Ct)-G*X*((G==0?P/2:0)+(Ue?ae/2:0));let be={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},_n=Gt?null:new Path2D,en=null;if(ft!=null)en=d.data[ft.series[1]];else{let{y0:Pt,y1:Yt}=c;Pt!=null&&Yt!=null&&(A=Yt.values(d,g,v,m),en=Pt.values(d,g,v,m))}let hn=N*Ct,z=J*Ct;for(let Pt=X==1?v:m;Pt>=v&&Pt<=m;Pt+=X){let Yt=A[Pt];if(Yt==null)continue;if(en!=null){let q=en[Pt]??0;if(Yt-q==0)continue;mt=_(q,R,L,V)}let le=M.distr!=2||c!=null?y[Pt]:Pt,bt=E(le,M,F,T),Be=_(Ee(Yt,et),R,L,V),Vt=D(bt-xt),$t=D(Qn(Be,mt)),C=D(zi(Be,mt)),S=$t-C;if(Yt!=null){let q=Yt<0?z:hn,ht=Yt<0?hn:z;Gt?(ae>0&&re[Pt]!=null&&Z(Je.get(re[Pt]),Vt,C+pi(ae/2),Ct,Qn(0,S-ae),q,ht),pe[Pt]!=null&&Z(ue.get(pe[Pt]),Vt,C+pi(ae/2),Ct,Qn(0,S-ae),q,ht)):Z(_n,Vt,C+pi(ae/2),Ct,Qn(0,S-ae),q,ht),nt(d,g,Pt,Vt-ae/2,C,Ct+ae,S)}}return ae>0?be.stroke=Gt?Je:_n:Gt||(be._fill=p.width==0?p._fill:p._stroke??p._fill,be.width=0),be.fill=Gt?ue:_n,be})}function RT(n,t){let e=Ee(t?.alignGaps,0);return(i,s,r,o)=>Rr(i,s,(a,l,c,u,f,h,d,g,v,m,p)=>{[r,o]=yh(c,r,o);let y=a.pxRound,A=N=>y(h(N,u,m,g)),M=N=>y(d(N,f,p,v)),R,E,_;u.ori==0?(R=Th,_=No,E=w0):(R=Eh,_=Uo,E=T0);let T=u.dir*(u.ori==0?1:-1),V=A(l[T==1?r:o]),F=V,L=[],D=[];for(let N=T==1?r:o;N>=r&&N<=o;N+=T)if(c[N]!=null){let X=l[N],Z=A(X);L.push(F=Z),D.push(M(c[N]))}let G={stroke:n(L,D,R,_,E,y),fill:null,clip:null,band:null,gaps:null,flags:Lo},P=G.stroke,[W,O]=td(i,s);if(a.fill!=null||W!=0){let N=G.fill=new Path2D(P),J=a.fillTo(i,s,a.min,a.max,W),X=M(J);_(N,F,X),_(N,V,X)}if(!a.spanGaps){let N=[];N.push(...ed(l,c,r,o,T,A,e)),G.gaps=N=a.gaps(i,s,r,o,N),G.clip=wh(N,u.ori,g,v,m,p)}return O!=0&&(G.band=O==2?[Cs(i,s,r,o,P,-1),Cs(i,s,r,o,P,1)]:Cs(i,s,r,o,P,O)),G})}function PT(n){return RT(IT,n)}function IT(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=t[h+1]-t[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,t[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,t[h+1]-l[h+1]*f[h]/3,n[h+1],t[h+1])}return a}var Vf=new Set;function Hg(){for(let n of Vf)n.syncRect(!0)}Do&&(Ar(uw,Co,Hg),Ar(fw,Co,Hg,!0),Ar(_h,Co,()=>{Dn.pxRatio=Re}));var LT=C0(),DT=E0();function Wg(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Gf(r,o,t,e))}function NT(n,t){return n.map((e,i)=>i==0?{}:gn({},t,e))}function Gf(n,t,e,i){return gn({},t==0?e:i,n)}function R0(n,t,e){return t==null?Po:[t,e]}var UT=R0;function FT(n,t,e){return t==null?Po:xh(t,e,qf,!0)}function P0(n,t,e,i){return t==null?Po:Sh(t,e,n.scales[i].log,!1)}var OT=P0;function I0(n,t,e,i){return t==null?Po:$f(t,e,n.scales[i].log,!1)}var BT=I0;function kT(n,t,e,i,s){let r=Qn(Mg(n),Mg(t)),o=t-n,a=ki(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?tr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Xg(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=bn((e=+s)*Re))+"px"),[n,t,e]}function zT(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ge(t[2]*Re,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Dn(n,t,e){let i={mode:Ee(n.mode,1)},s=i.mode;function r(x,b,I,U){let $=b.valToPct(x);return U+I*(b.dir==-1?1-$:$)}function o(x,b,I,U){let $=b.valToPct(x);return U+I*(b.dir==-1?$:1-$)}function a(x,b,I,U){return b.ori==0?r(x,b,I,U):o(x,b,I,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=bi(qb);if(n.id!=null&&(c.id=n.id),di(c,n.class),n.title){let x=bi(Jb,c);x.textContent=n.title}let u=Bi("canvas"),f=i.ctx=u.getContext("2d"),h=bi(Kb,c);Ar("click",h,x=>{x.target===g&&(Xe!=Or||Ke!=Br)&&Un.click(i,x)},!0);let d=i.under=bi(jb,h);h.appendChild(u);let g=i.over=bi(Qb,h);n=Io(n);let v=+Ee(n.pxAlign,1),m=Vg(v);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let p=n.ms||.001,y=i.series=s==1?Wg(n.series||[],Ng,kg,!1):NT(n.series||[null],Bg),A=i.axes=Wg(n.axes||[],Dg,Fg,!0),M=i.scales={},R=i.bands=n.bands||[];R.forEach(x=>{x.fill=Me(x.fill||null),x.dir=Ee(x.dir,-1)});let E=s==2?y[1].facets[0].scale:y[0].scale,_={axes:hs,series:ge},T=(n.drawOrder||["axes","series"]).map(x=>_[x]);function V(x){let b=x.distr==3?I=>As(I>0?I:x.clamp(i,I,x.min,x.max,x.key)):x.distr==4?I=>Rf(I,x.asinh):x.distr==100?I=>x.fwd(I):I=>I;return I=>{let U=b(I),{_min:$,_max:Q}=x,lt=Q-$;return(U-$)/lt}}function F(x){let b=M[x];if(b==null){let I=(n.scales||Ha)[x]||Ha;if(I.from!=null){F(I.from);let U=gn({},M[I.from],I,{key:x});U.valToPct=V(U),M[x]=U}else{b=M[x]=gn({},x==E?v0:MT,I),b.key=x;let U=b.time,$=b.range,Q=Qs($);if((x!=E||s==2&&!U)&&(Q&&($[0]==null||$[1]==null)&&($={min:$[0]==null?vg:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?vg:{mode:1,hard:$[1],soft:$[1]}},Q=!1),!Q&&bh($))){let lt=$;$=(dt,yt,Nt)=>yt==null?Po:xh(yt,Nt,lt)}b.range=Me($||(U?UT:x==E?b.distr==3?OT:b.distr==4?BT:R0:b.distr==3?P0:b.distr==4?I0:FT)),b.auto=Me(Q?!1:b.auto),b.clamp=Me(b.clamp||ST),b._min=b._max=null,b.valToPct=V(b)}}}F("x"),F("y"),s==1&&y.forEach(x=>{F(x.scale)}),A.forEach(x=>{F(x.scale)});for(let x in n.scales)F(x);let L=M[E],D=L.distr,G,P;L.ori==0?(di(c,Yb),G=r,P=o):(di(c,Zb),G=o,P=r);let W={};for(let x in M){let b=M[x];(b.min!=null||b.max!=null)&&(W[x]={min:b.min,max:b.max},b.min=b.max=null)}let O=n.tzDate||(x=>new Date(bn(x/p))),N=n.fmtDate||Jf,J=p==1?Yw(O):Kw(O),X=Pg(O,Rg(p==1?qw:Jw,N)),Z=Lg(O,Ig(Qw,N)),nt=[],ft=i.legend=gn({},nT,n.legend),ut=i.cursor=gn({},lT,{drag:{y:s==2}},n.cursor),et=ft.show,mt=ut.show,xt=ft.markers;ft.idxs=nt,xt.width=Me(xt.width),xt.dash=Me(xt.dash),xt.stroke=Me(xt.stroke),xt.fill=Me(xt.fill);let Ct,Mt,Wt,ae=[],Gt=[],pe,ue=!1,re={};if(ft.live){let x=y[1]?y[1].values:null;ue=x!=null,pe=ue?x(i,1,0):{_:0};for(let b in pe)re[b]=Wf}if(et)if(Ct=Bi("table",rw,c),Wt=Bi("tbody",null,Ct),ft.mount(i,Ct),ue){Mt=Bi("thead",null,Ct,Wt);let x=Bi("tr",null,Mt);Bi("th",null,x);for(var Je in pe)Bi("th",og,x).textContent=Je}else di(Ct,aw),ft.live&&di(Ct,ow);let He={show:!0},cn={show:!1};function Ue(x,b){if(b==0&&(ue||!ft.live||s==2))return Po;let I=[],U=Bi("tr",lw,Wt,Wt.childNodes[b]);di(U,x.class),x.show||di(U,Er);let $=Bi("th",null,U);if(xt.show){let dt=bi(cw,$);if(b>0){let yt=xt.width(i,b);yt&&(dt.style.border=yt+"px "+xt.dash(i,b)+" "+xt.stroke(i,b)),dt.style.background=xt.fill(i,b)}}let Q=bi(og,$);x.label instanceof HTMLElement?Q.appendChild(x.label):Q.textContent=x.label,b>0&&(xt.show||(Q.style.color=x.width>0?xt.stroke(i,b):xt.fill(i,b)),be("click",$,dt=>{if(ut._lock)return;jt(dt);let yt=y.indexOf(x);if((dt.ctrlKey||dt.metaKey)!=ft.isolate){let Nt=y.some((Ut,Ot)=>Ot>0&&Ot!=yt&&Ut.show);y.forEach((Ut,Ot)=>{Ot>0&&Wi(Ot,Nt?Ot==yt?He:cn:He,!0,pn.setSeries)})}else Wi(yt,{show:!x.show},!0,pn.setSeries)},!1),Qt&&be(hg,$,dt=>{ut._lock||(jt(dt),Wi(y.indexOf(x),zr,!0,pn.setSeries))},!1));for(var lt in pe){let dt=Bi("td",hw,U);dt.textContent="--",I.push(dt)}return[U,I]}let Tn=new Map;function be(x,b,I,U=!0){let $=Tn.get(b)||{},Q=ut.bind[x](i,b,I,U);Q&&(Ar(x,b,$[x]=Q),Tn.set(b,$))}function _n(x,b,I){let U=Tn.get(b)||{};for(let $ in U)(x==null||$==x)&&(Ff($,b,U[$]),delete U[$]);x==null&&Tn.delete(b)}let en=0,hn=0,z=0,Pt=0,Yt=0,le=0,bt=Yt,Be=le,Vt=z,$t=Pt,C=0,S=0,q=0,ht=0;i.bbox={};let at=!1,_t=!1,vt=!1,it=!1,rt=!1,pt=!1;function B(x,b,I){(I||x!=i.width||b!=i.height)&&ot(x,b),fe(!1),vt=!0,_t=!0,On()}function ot(x,b){i.width=en=z=x,i.height=hn=Pt=b,Yt=le=0,St(),Ht();let I=i.bbox;C=I.left=wr(Yt*Re,.5),S=I.top=wr(le*Re,.5),q=I.width=wr(z*Re,.5),ht=I.height=wr(Pt*Re,.5)}let st=3;function wt(){let x=!1,b=0;for(;!x;){b++;let I=Nr(b),U=Hi(b);x=b==st||I&&U,x||(ot(i.width,i.height),_t=!0)}}function gt({width:x,height:b}){B(x,b)}i.setSize=gt;function St(){let x=!1,b=!1,I=!1,U=!1;A.forEach(($,Q)=>{if($.show&&$._show){let{side:lt,_size:dt}=$,yt=lt%2,Nt=$.label!=null?$.labelSize:0,Ut=dt+Nt;Ut>0&&(yt?(z-=Ut,lt==3?(Yt+=Ut,U=!0):I=!0):(Pt-=Ut,lt==0?(le+=Ut,x=!0):b=!0))}}),Vi[0]=x,Vi[1]=I,Vi[2]=b,Vi[3]=U,z-=Ti[1]+Ti[3],Yt+=Ti[3],Pt-=Ti[2]+Ti[0],le+=Ti[0]}function Ht(){let x=Yt+z,b=le+Pt,I=Yt,U=le;function $(Q,lt){switch(Q){case 1:return x+=lt,x-lt;case 2:return b+=lt,b-lt;case 3:return I-=lt,I+lt;case 0:return U-=lt,U+lt}}A.forEach((Q,lt)=>{if(Q.show&&Q._show){let dt=Q.side;Q._pos=$(dt,Q._size),Q.label!=null&&(Q._lpos=$(dt,Q.labelSize))}})}if(ut.dataIdx==null){let x=ut.hover,b=x.skip=new Set(x.skip??[]);b.add(void 0);let I=x.prox=Me(x.prox),U=x.bias??=0;ut.dataIdx=($,Q,lt,dt)=>{if(Q==0)return lt;let yt=lt,Nt=I($,Q,lt,dt)??Ve,Ut=Nt>=0&&Nt<Ve,Ot=L.ori==0?z:Pt,oe=ut.left,Ae=t[0],Te=t[Q];if(b.has(Te[lt])){yt=null;let xe=null,Kt=null,Xt;if(U==0||U==-1)for(Xt=lt;xe==null&&Xt-- >0;)b.has(Te[Xt])||(xe=Xt);if(U==0||U==1)for(Xt=lt;Kt==null&&Xt++<Te.length;)b.has(Te[Xt])||(Kt=Xt);if(xe!=null||Kt!=null)if(Ut){let qe=xe==null?-1/0:G(Ae[xe],L,Ot,0),rn=Kt==null?1/0:G(Ae[Kt],L,Ot,0),Rn=oe-qe,Fe=rn-oe;Rn<=Fe?Rn<=Nt&&(yt=xe):Fe<=Nt&&(yt=Kt)}else yt=Kt==null?xe:xe==null?Kt:lt-xe<=Kt-lt?xe:Kt}else Ut&&wn(oe-G(Ae[lt],L,Ot,0))>Nt&&(yt=null);return yt}}let jt=x=>{ut.event=x};ut.idxs=nt,ut._lock=!1;let ct=ut.points;ct.show=Me(ct.show),ct.size=Me(ct.size),ct.stroke=Me(ct.stroke),ct.width=Me(ct.width),ct.fill=Me(ct.fill);let Bt=i.focus=gn({},n.focus||{alpha:.3},ut.focus),Qt=Bt.prox>=0,Rt=Qt&&ct.one,he=[],We=[],Wn=[];function Bo(x,b){let I=ct.show(i,b);if(I instanceof HTMLElement)return di(I,sw),di(I,x.class),rs(I,-10,-10,z,Pt),g.insertBefore(I,he[b]),I}function Ir(x,b){if(s==1||b>0){let I=s==1&&M[x.scale].time,U=x.value;x.value=I?Tg(U)?Lg(O,Ig(U,N)):U||Z:U||xT,x.label=x.label||(I?hT:cT)}if(Rt||b>0){x.width=x.width==null?1:x.width,x.paths=x.paths||LT||Mw,x.fillTo=Me(x.fillTo||bT),x.pxAlign=+Ee(x.pxAlign,v),x.pxRound=Vg(x.pxAlign),x.stroke=Me(x.stroke||null),x.fill=Me(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let I=vT(Qn(1,x.width),1),U=x.points=gn({},{size:I,width:Qn(1,I*.2),stroke:x.stroke,space:I*2,paths:DT,_stroke:null,_fill:null},x.points);U.show=Me(U.show),U.filter=Me(U.filter),U.fill=Me(U.fill),U.stroke=Me(U.stroke),U.paths=Me(U.paths),U.pxAlign=x.pxAlign}if(et){let I=Ue(x,b);ae.splice(b,0,I[0]),Gt.splice(b,0,I[1]),ft.values.push(null)}if(mt){nt.splice(b,0,null);let I=null;Rt?b==0&&(I=Bo(x,b)):b>0&&(I=Bo(x,b)),he.splice(b,0,I),We.splice(b,0,0),Wn.splice(b,0,0)}Cn("addSeries",b)}function Lh(x,b){b=b??y.length,x=s==1?Gf(x,b,Ng,kg):Gf(x,b,{},Bg),y.splice(b,0,x),Ir(y[b],b)}i.addSeries=Lh;function Ya(x){if(y.splice(x,1),et){ft.values.splice(x,1),Gt.splice(x,1);let b=ae.splice(x,1)[0];_n(null,b.firstChild),b.remove()}mt&&(nt.splice(x,1),he.splice(x,1)[0].remove(),We.splice(x,1),Wn.splice(x,1)),Cn("delSeries",x)}i.delSeries=Ya;let Vi=[!1,!1,!1,!1];function as(x,b){if(x._show=x.show,x.show){let I=x.side%2,U=M[x.scale];U==null&&(x.scale=I?y[1].scale:E,U=M[x.scale]);let $=U.time;x.size=Me(x.size),x.space=Me(x.space),x.rotate=Me(x.rotate),Qs(x.incrs)&&x.incrs.forEach(lt=>{!tr.has(lt)&&tr.set(lt,t0(lt))}),x.incrs=Me(x.incrs||(U.distr==2?Ww:$?p==1?$w:Zw:Tr)),x.splits=Me(x.splits||($&&U.distr==1?J:U.distr==3?Bf:U.distr==4?dT:fT)),x.stroke=Me(x.stroke),x.grid.stroke=Me(x.grid.stroke),x.ticks.stroke=Me(x.ticks.stroke),x.border.stroke=Me(x.border.stroke);let Q=x.values;x.values=Qs(Q)&&!Qs(Q[0])?Me(Q):$?Qs(Q)?Pg(O,Rg(Q,N)):Tg(Q)?jw(O,Q):Q||X:Q||uT,x.filter=Me(x.filter||(U.distr>=3&&U.log==10?gT:U.distr==3&&U.log==2?_T:jg)),x.font=Xg(x.font),x.labelFont=Xg(x.labelFont),x._size=x.size(i,null,b,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Vi[b]=!0,x._el=bi(tw,h))}}function ls(x,b,I,U){let[$,Q,lt,dt]=I,yt=b%2,Nt=0;return yt==0&&(dt||Q)&&(Nt=b==0&&!$||b==2&&!lt?bn(Dg.size/3):0),yt==1&&($||lt)&&(Nt=b==1&&!Q||b==3&&!dt?bn(Fg.size/2):0),Nt}let ko=i.padding=(n.padding||[ls,ls,ls,ls]).map(x=>Me(Ee(x,ls))),Ti=i._padding=ko.map((x,b)=>x(i,b,Vi,0)),nn,an=null,ln=null,Gi=s==1?y[0].idxs:null,ii=null,Rs=!1;function zo(x,b){if(t=x??[],i.data=i._data=t,s==2){nn=0;for(let I=1;I<y.length;I++)nn+=t[I][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ii=t[0],nn=ii.length;let I=t;if(D==2){I=t.slice();let U=I[0]=Array(nn);for(let $=0;$<nn;$++)U[$]=$}i._data=t=I}if(fe(!0),Cn("setData"),D==2&&(vt=!0),b!==!1){let I=L;I.auto(i,Rs)?Vo():Ls(E,I.min,I.max),it=it||ut.left>=0,pt=!0,On()}}i.setData=zo;function Vo(){Rs=!0;let x,b;s==1&&(nn>0?(an=Gi[0]=0,ln=Gi[1]=nn-1,x=t[0][an],b=t[0][ln],D==2?(x=an,b=ln):x==b&&(D==3?[x,b]=Sh(x,x,L.log,!1):D==4?[x,b]=$f(x,x,L.log,!1):L.time?b=x+bn(86400/p):[x,b]=xh(x,b,qf,!0))):(an=Gi[0]=x=null,ln=Gi[1]=b=null)),Ls(E,x,b)}let Lr,Ps,Dr,w,H,tt,K,j,Tt,It;function Et(x,b,I,U,$,Q){x??=lg,I??=Zf,U??="butt",$??=lg,Q??="round",x!=Lr&&(f.strokeStyle=Lr=x),$!=Ps&&(f.fillStyle=Ps=$),b!=Dr&&(f.lineWidth=Dr=b),Q!=H&&(f.lineJoin=H=Q),U!=tt&&(f.lineCap=tt=U),I!=w&&f.setLineDash(w=I)}function Lt(x,b,I,U){b!=Ps&&(f.fillStyle=Ps=b),x!=K&&(f.font=K=x),I!=j&&(f.textAlign=j=I),U!=Tt&&(f.textBaseline=Tt=U)}function zt(x,b,I,U,$=0){if(U.length>0&&x.auto(i,Rs)&&(b==null||b.min==null)){let Q=Ee(an,0),lt=Ee(ln,U.length-1),dt=I.min==null?gw(U,Q,lt,$,x.distr==3):[I.min,I.max];x.min=zi(x.min,I.min=dt[0]),x.max=Qn(x.max,I.max=dt[1])}}let ee={min:null,max:null};function me(){for(let U in M){let $=M[U];W[U]==null&&($.min==null||W[E]!=null&&$.auto(i,Rs))&&(W[U]=ee)}for(let U in M){let $=M[U];W[U]==null&&$.from!=null&&W[$.from]!=null&&(W[U]=ee)}W[E]!=null&&fe(!0);let x={};for(let U in W){let $=W[U];if($!=null){let Q=x[U]=Io(M[U],Tw);if($.min!=null)gn(Q,$);else if(U!=E||s==2)if(nn==0&&Q.from==null){let lt=Q.range(i,null,null,U);Q.min=lt[0],Q.max=lt[1]}else Q.min=Ve,Q.max=-Ve}}if(nn>0){y.forEach((U,$)=>{if(s==1){let Q=U.scale,lt=W[Q];if(lt==null)return;let dt=x[Q];if($==0){let yt=dt.range(i,dt.min,dt.max,Q);dt.min=yt[0],dt.max=yt[1],an=ki(dt.min,t[0]),ln=ki(dt.max,t[0]),ln-an>1&&(t[0][an]<dt.min&&an++,t[0][ln]>dt.max&&ln--),U.min=ii[an],U.max=ii[ln]}else U.show&&U.auto&&zt(dt,lt,U,t[$],U.sorted);U.idxs[0]=an,U.idxs[1]=ln}else if($>0&&U.show&&U.auto){let[Q,lt]=U.facets,dt=Q.scale,yt=lt.scale,[Nt,Ut]=t[$],Ot=x[dt],oe=x[yt];Ot!=null&&zt(Ot,W[dt],Q,Nt,Q.sorted),oe!=null&&zt(oe,W[yt],lt,Ut,lt.sorted),U.min=lt.min,U.max=lt.max}});for(let U in x){let $=x[U],Q=W[U];if($.from==null&&(Q==null||Q.min==null)){let lt=$.range(i,$.min==Ve?null:$.min,$.max==-Ve?null:$.max,U);$.min=lt[0],$.max=lt[1]}}}for(let U in x){let $=x[U];if($.from!=null){let Q=x[$.from];if(Q.min==null)$.min=$.max=null;else{let lt=$.range(i,Q.min,Q.max,U);$.min=lt[0],$.max=lt[1]}}}let b={},I=!1;for(let U in x){let $=x[U],Q=M[U];if(Q.min!=$.min||Q.max!=$.max){Q.min=$.min,Q.max=$.max;let lt=Q.distr;Q._min=lt==3?As(Q.min):lt==4?Rf(Q.min,Q.asinh):lt==100?Q.fwd(Q.min):Q.min,Q._max=lt==3?As(Q.max):lt==4?Rf(Q.max,Q.asinh):lt==100?Q.fwd(Q.max):Q.max,b[U]=I=!0}}if(I){y.forEach((U,$)=>{s==2?$>0&&b.y&&(U._paths=null):b[U.scale]&&(U._paths=null)});for(let U in b)vt=!0,Cn("setScale",U);mt&&ut.left>=0&&(it=pt=!0)}for(let U in W)W[U]=null}function kt(x){let b=Of(an-1,0,nn-1),I=Of(ln+1,0,nn-1);for(;x[b]==null&&b>0;)b--;for(;x[I]==null&&I<nn-1;)I++;return[b,I]}function ge(){if(nn>0){let x=y.some(b=>b._focus)&&It!=Bt.alpha;x&&(f.globalAlpha=It=Bt.alpha),y.forEach((b,I)=>{if(I>0&&b.show&&(Qe(I,!1),Qe(I,!0),b._paths==null)){let U=It;It!=b.alpha&&(f.globalAlpha=It=b.alpha);let $=s==2?[0,t[I][0].length-1]:kt(t[I]);b._paths=b.paths(i,I,$[0],$[1]),It!=U&&(f.globalAlpha=It=U)}}),y.forEach((b,I)=>{if(I>0&&b.show){let U=It;It!=b.alpha&&(f.globalAlpha=It=b.alpha),b._paths!=null&&Le(I,!1);{let $=b._paths!=null?b._paths.gaps:null,Q=b.points.show(i,I,an,ln,$),lt=b.points.filter(i,I,Q,$);(Q||lt)&&(b.points._paths=b.points.paths(i,I,an,ln,lt),Le(I,!0))}It!=U&&(f.globalAlpha=It=U),Cn("drawSeries",I)}}),x&&(f.globalAlpha=It=1)}}function Qe(x,b){let I=b?y[x].points:y[x];I._stroke=I.stroke(i,x),I._fill=I.fill(i,x)}function Le(x,b){let I=b?y[x].points:y[x],{stroke:U,fill:$,clip:Q,flags:lt,_stroke:dt=I._stroke,_fill:yt=I._fill,_width:Nt=I.width}=I._paths;Nt=Ge(Nt*Re,3);let Ut=null,Ot=Nt%2/2;b&&yt==null&&(yt=Nt>0?"#fff":dt);let oe=I.pxAlign==1&&Ot>0;if(oe&&f.translate(Ot,Ot),!b){let Ae=C-Nt/2,Te=S-Nt/2,xe=q+Nt,Kt=ht+Nt;Ut=new Path2D,Ut.rect(Ae,Te,xe,Kt)}b?Ft(dt,Nt,I.dash,I.cap,yt,U,$,lt,Q):De(x,dt,Nt,I.dash,I.cap,yt,U,$,lt,Ut,Q),oe&&f.translate(-Ot,-Ot)}function De(x,b,I,U,$,Q,lt,dt,yt,Nt,Ut){let Ot=!1;yt!=0&&R.forEach((oe,Ae)=>{if(oe.series[0]==x){let Te=y[oe.series[1]],xe=t[oe.series[1]],Kt=(Te._paths||Ha).band;Qs(Kt)&&(Kt=oe.dir==1?Kt[0]:Kt[1]);let Xt,qe=null;Te.show&&Kt&&xw(xe,an,ln)?(qe=oe.fill(i,Ae)||Q,Xt=Te._paths.clip):Kt=null,Ft(b,I,U,$,qe,lt,dt,yt,Nt,Ut,Xt,Kt),Ot=!0}}),Ot||Ft(b,I,U,$,Q,lt,dt,yt,Nt,Ut)}let xn=Lo|zf;function Ft(x,b,I,U,$,Q,lt,dt,yt,Nt,Ut,Ot){Et(x,b,I,U,$),(yt||Nt||Ot)&&(f.save(),yt&&f.clip(yt),Nt&&f.clip(Nt)),Ot?(dt&xn)==xn?(f.clip(Ot),Ut&&f.clip(Ut),ve($,lt),un(x,Q,b)):dt&zf?(ve($,lt),f.clip(Ot),un(x,Q,b)):dt&Lo&&(f.save(),f.clip(Ot),Ut&&f.clip(Ut),ve($,lt),f.restore(),un(x,Q,b)):(ve($,lt),un(x,Q,b)),(yt||Nt||Ot)&&f.restore()}function un(x,b,I){I>0&&(b instanceof Map?b.forEach((U,$)=>{f.strokeStyle=Lr=$,f.stroke(U)}):b!=null&&x&&f.stroke(b))}function ve(x,b){b instanceof Map?b.forEach((I,U)=>{f.fillStyle=Ps=U,f.fill(I)}):b!=null&&x&&f.fill(b)}function cs(x,b,I,U){let $=A[x],Q;if(U<=0)Q=[0,0];else{let lt=$._space=$.space(i,x,b,I,U),dt=$._incrs=$.incrs(i,x,b,I,U,lt);Q=kT(b,I,dt,U,lt)}return $._found=Q}function fn(x,b,I,U,$,Q,lt,dt,yt,Nt){let Ut=lt%2/2;v==1&&f.translate(Ut,Ut),Et(dt,lt,yt,Nt,dt),f.beginPath();let Ot,oe,Ae,Te,xe=$+(U==0||U==3?-Q:Q);I==0?(oe=$,Te=xe):(Ot=$,Ae=xe);for(let Kt=0;Kt<x.length;Kt++)b[Kt]!=null&&(I==0?Ot=Ae=x[Kt]:oe=Te=x[Kt],f.moveTo(Ot,oe),f.lineTo(Ae,Te));f.stroke(),v==1&&f.translate(-Ut,-Ut)}function Nr(x){let b=!0;return A.forEach((I,U)=>{if(!I.show)return;let $=M[I.scale];if($.min==null){I._show&&(b=!1,I._show=!1,fe(!1));return}else I._show||(b=!1,I._show=!0,fe(!1));let Q=I.side,lt=Q%2,{min:dt,max:yt}=$,[Nt,Ut]=cs(U,dt,yt,lt==0?z:Pt);if(Ut==0)return;let Ot=$.distr==2,oe=I._splits=I.splits(i,U,dt,yt,Nt,Ut,Ot),Ae=$.distr==2?oe.map(Xt=>ii[Xt]):oe,Te=$.distr==2?ii[oe[1]]-ii[oe[0]]:Nt,xe=I._values=I.values(i,I.filter(i,Ae,U,Ut,Te),U,Ut,Te);I._rotate=Q==2?I.rotate(i,xe,U,Ut):0;let Kt=I._size;I._size=wi(I.size(i,xe,U,x)),Kt!=null&&I._size!=Kt&&(b=!1)}),b}function Hi(x){let b=!0;return ko.forEach((I,U)=>{let $=I(i,U,Vi,x);$!=Ti[U]&&(b=!1),Ti[U]=$}),b}function hs(){for(let x=0;x<A.length;x++){let b=A[x];if(!b.show||!b._show)continue;let I=b.side,U=I%2,$,Q,lt=b.stroke(i,x),dt=I==0||I==3?-1:1,[yt,Nt]=b._found;if(b.label!=null){let qn=b.labelGap*dt,oi=bn((b._lpos+qn)*Re);Lt(b.labelFont[0],lt,"center",I==2?"top":ag),f.save(),U==1?($=Q=0,f.translate(oi,bn(S+ht/2)),f.rotate((I==3?-gh:gh)/2)):($=bn(C+q/2),Q=oi);let lr=Jg(b.label)?b.label(i,x,yt,Nt):b.label;f.fillText(lr,$,Q),f.restore()}if(Nt==0)continue;let Ut=M[b.scale],Ot=U==0?q:ht,oe=U==0?C:S,Ae=b._splits,Te=Ut.distr==2?Ae.map(qn=>ii[qn]):Ae,xe=Ut.distr==2?ii[Ae[1]]-ii[Ae[0]]:yt,Kt=b.ticks,Xt=b.border,qe=Kt.show?Kt.size:0,rn=bn(qe*Re),Rn=bn((b.alignTo==2?b._size-qe-b.gap:b.gap)*Re),Fe=b._rotate*-gh/180,on=m(b._pos*Re),si=(rn+Rn)*dt,$n=on+si;Q=U==0?$n:0,$=U==1?$n:0;let gi=b.font[0],Ei=b.align==1?Eo:b.align==2?Ef:Fe>0?Eo:Fe<0?Ef:U==0?"center":I==3?Ef:Eo,$i=Fe||U==1?"middle":I==2?"top":ag;Lt(gi,lt,Ei,$i);let ri=b.font[1]*b.lineGap,_i=Ae.map(qn=>m(a(qn,Ut,Ot,oe))),Ai=b._values;for(let qn=0;qn<Ai.length;qn++){let oi=Ai[qn];if(oi!=null){U==0?$=_i[qn]:Q=_i[qn],oi=""+oi;let lr=oi.indexOf(`
`)==-1?[oi]:oi.split(/\n/gm);for(let Yn=0;Yn<lr.length;Yn++){let Rd=lr[Yn];Fe?(f.save(),f.translate($,Q+Yn*ri),f.rotate(Fe),f.fillText(Rd,0,0),f.restore()):f.fillText(Rd,$,Q+Yn*ri)}}}Kt.show&&fn(_i,Kt.filter(i,Te,x,Nt,xe),U,I,on,rn,Ge(Kt.width*Re,3),Kt.stroke(i,x),Kt.dash,Kt.cap);let qi=b.grid;qi.show&&fn(_i,qi.filter(i,Te,x,Nt,xe),U,U==0?2:1,U==0?S:C,U==0?ht:q,Ge(qi.width*Re,3),qi.stroke(i,x),qi.dash,qi.cap),Xt.show&&fn([on],[1],U==0?1:0,U==0?1:2,U==1?S:C,U==1?ht:q,Ge(Xt.width*Re,3),Xt.stroke(i,x),Xt.dash,Xt.cap)}Cn("drawAxes")}function fe(x){y.forEach((b,I)=>{I>0&&(b._paths=null,x&&(s==1?(b.min=null,b.max=null):b.facets.forEach(U=>{U.min=null,U.max=null})))})}let sn=!1,Xn=!1,Ne=[];function dn(){Xn=!1;for(let x=0;x<Ne.length;x++)Cn(...Ne[x]);Ne.length=0}function On(){sn||(Lw(ud),sn=!0)}function Za(x,b=!1){sn=!0,Xn=b,x(i),ud(),b&&Ne.length>0&&queueMicrotask(dn)}i.batch=Za;function ud(){if(at&&(me(),at=!1),vt&&(wt(),vt=!1),_t){if(Ze(d,Eo,Yt),Ze(d,"top",le),Ze(d,ka,z),Ze(d,za,Pt),Ze(g,Eo,Yt),Ze(g,"top",le),Ze(g,ka,z),Ze(g,za,Pt),Ze(h,ka,en),Ze(h,za,hn),u.width=bn(en*Re),u.height=bn(hn*Re),A.forEach(({_el:x,_show:b,_size:I,_pos:U,side:$})=>{if(x!=null)if(b){let Q=$===3||$===0?I:0,lt=$%2==1;Ze(x,lt?"left":"top",U-Q),Ze(x,lt?"width":"height",I),Ze(x,lt?"top":"left",lt?le:Yt),Ze(x,lt?"height":"width",lt?Pt:z),Uf(x,Er)}else di(x,Er)}),Lr=Ps=Dr=H=tt=K=j=Tt=w=null,It=1,Wo(!0),Yt!=bt||le!=Be||z!=Vt||Pt!=$t){fe(!1);let x=z/Vt,b=Pt/$t;if(mt&&!it&&ut.left>=0){ut.left*=x,ut.top*=b,Ur&&rs(Ur,bn(ut.left),0,z,Pt),Fr&&rs(Fr,0,bn(ut.top),z,Pt);for(let I=0;I<he.length;I++){let U=he[I];U!=null&&(We[I]*=x,Wn[I]*=b,rs(U,wi(We[I]),wi(Wn[I]),z,Pt))}}if($e.show&&!rt&&$e.left>=0&&$e.width>0){$e.left*=x,$e.width*=x,$e.top*=b,$e.height*=b;for(let I in Bh)Ze(kr,I,$e[I])}bt=Yt,Be=le,Vt=z,$t=Pt}Cn("setSize"),_t=!1}en>0&&hn>0&&(f.clearRect(0,0,u.width,u.height),Cn("drawClear"),T.forEach(x=>x()),Cn("draw")),$e.show&&rt&&(Ja($e),rt=!1),mt&&it&&(ar(null,!0,!1),it=!1),ft.show&&ft.live&&pt&&(Fh(),pt=!1),l||(l=!0,i.status=1,Cn("ready")),Rs=!1,sn=!1}i.redraw=(x,b)=>{vt=b||!1,x!==!1?Ls(E,L.min,L.max):On()};function Dh(x,b){let I=M[x];if(I.from==null){if(nn==0){let U=I.range(i,b.min,b.max,x);b.min=U[0],b.max=U[1]}if(b.min>b.max){let U=b.min;b.min=b.max,b.max=U}if(nn>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;x==E&&I.distr==2&&nn>0&&(b.min=ki(b.min,t[0]),b.max=ki(b.max,t[0]),b.min==b.max&&b.max++),W[x]=b,at=!0,On()}}i.setScale=Dh;let Nh,Uh,Ur,Fr,fd,dd,Or,Br,pd,md,Xe,Ke,Is=!1,Un=ut.drag,En=Un.x,An=Un.y;mt&&(ut.x&&(Nh=bi(nw,g)),ut.y&&(Uh=bi(iw,g)),L.ori==0?(Ur=Nh,Fr=Uh):(Ur=Uh,Fr=Nh),Xe=ut.left,Ke=ut.top);let $e=i.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),kr=$e.show?bi(ew,$e.over?g:d):null;function Ja(x,b){if($e.show){for(let I in x)$e[I]=x[I],I in Bh&&Ze(kr,I,x[I]);b!==!1&&Cn("setSelect")}}i.setSelect=Ja;function m_(x){if(y[x].show)et&&Uf(ae[x],Er);else if(et&&di(ae[x],Er),mt){let I=Rt?he[0]:he[x];I!=null&&rs(I,-10,-10,z,Pt)}}function Ls(x,b,I){Dh(x,{min:b,max:I})}function Wi(x,b,I,U){b.focus!=null&&y_(x),b.show!=null&&y.forEach(($,Q)=>{Q>0&&(x==Q||x==null)&&($.show=b.show,m_(Q),s==2?(Ls($.facets[0].scale,null,null),Ls($.facets[1].scale,null,null)):Ls($.scale,null,null),On())}),I!==!1&&Cn("setSeries",x,b),U&&Xo("setSeries",i,x,b)}i.setSeries=Wi;function g_(x,b){gn(R[x],b)}function __(x,b){x.fill=Me(x.fill||null),x.dir=Ee(x.dir,-1),b=b??R.length,R.splice(b,0,x)}function x_(x){x==null?R.length=0:R.splice(x,1)}i.addBand=__,i.setBand=g_,i.delBand=x_;function v_(x,b){y[x].alpha=b,mt&&he[x]!=null&&(he[x].style.opacity=b),et&&ae[x]&&(ae[x].style.opacity=b)}let us,Ds,or,zr={focus:!0};function y_(x){if(x!=or){let b=x==null,I=Bt.alpha!=1;y.forEach((U,$)=>{if(s==1||$>0){let Q=b||$==0||$==x;U._focus=b?null:Q,I&&v_($,Q?1:Bt.alpha)}}),or=x,I&&On()}}et&&Qt&&be(ug,Ct,x=>{ut._lock||(jt(x),or!=null&&Wi(null,zr,!0,pn.setSeries))});function Xi(x,b,I){let U=M[b];I&&(x=x/Re-(U.ori==1?le:Yt));let $=z;U.ori==1&&($=Pt,x=$-x),U.dir==-1&&(x=$-x);let Q=U._min,lt=U._max,dt=x/$,yt=Q+(lt-Q)*dt,Nt=U.distr;return Nt==3?Ro(10,yt):Nt==4?yw(yt,U.asinh):Nt==100?U.bwd(yt):yt}function S_(x,b){let I=Xi(x,E,b);return ki(I,t[0],an,ln)}i.valToIdx=x=>ki(x,t[0]),i.posToIdx=S_,i.posToVal=Xi,i.valToPos=(x,b,I)=>M[b].ori==0?r(x,M[b],I?q:z,I?C:0):o(x,M[b],I?ht:Pt,I?S:0),i.setCursor=(x,b,I)=>{Xe=x.left,Ke=x.top,ar(null,b,I)};function gd(x,b){Ze(kr,Eo,$e.left=x),Ze(kr,ka,$e.width=b)}function _d(x,b){Ze(kr,"top",$e.top=x),Ze(kr,za,$e.height=b)}let Go=L.ori==0?gd:_d,Ho=L.ori==1?gd:_d;function M_(){if(et&&ft.live)for(let x=s==2?1:0;x<y.length;x++){if(x==0&&ue)continue;let b=ft.values[x],I=0;for(let U in b)Gt[x][I++].firstChild.nodeValue=b[U]}}function Fh(x,b){if(x!=null&&(x.idxs?x.idxs.forEach((I,U)=>{nt[U]=I}):ww(x.idx)||nt.fill(x.idx),ft.idx=nt[0]),et&&ft.live){for(let I=0;I<y.length;I++)(I>0||s==1&&!ue)&&b_(I,nt[I]);M_()}pt=!1,b!==!1&&Cn("setLegend")}i.setLegend=Fh;function b_(x,b){let I=y[x],U=x==0&&D==2?ii:t[x],$;ue?$=I.values(i,x,b)??re:($=I.value(i,b==null?null:U[b],x,b),$=$==null?re:{_:$}),ft.values[x]=$}function ar(x,b,I){pd=Xe,md=Ke,[Xe,Ke]=ut.move(i,Xe,Ke),ut.left=Xe,ut.top=Ke,mt&&(Ur&&rs(Ur,bn(Xe),0,z,Pt),Fr&&rs(Fr,0,bn(Ke),z,Pt));let U,$=an>ln;us=Ve,Ds=null;let Q=L.ori==0?z:Pt,lt=L.ori==1?z:Pt;if(Xe<0||nn==0||$){U=ut.idx=null;for(let dt=0;dt<y.length;dt++){let yt=he[dt];yt!=null&&rs(yt,-10,-10,z,Pt)}Qt&&Wi(null,zr,!0,x==null&&pn.setSeries),ft.live&&(nt.fill(U),pt=!0)}else{let dt,yt,Nt;s==1&&(dt=L.ori==0?Xe:Ke,yt=Xi(dt,E),U=ut.idx=ki(yt,t[0],an,ln),Nt=G(t[0][U],L,Q,0));let Ut=-10,Ot=-10,oe=0,Ae=0,Te=!0,xe="",Kt="";for(let Xt=s==2?1:0;Xt<y.length;Xt++){let qe=y[Xt],rn=nt[Xt],Rn=rn==null?null:s==1?t[Xt][rn]:t[Xt][1][rn],Fe=ut.dataIdx(i,Xt,U,yt),on=Fe==null?null:s==1?t[Xt][Fe]:t[Xt][1][Fe];if(pt=pt||on!=Rn||Fe!=rn,nt[Xt]=Fe,Xt>0&&qe.show){let si=Fe==null?-10:Fe==U?Nt:G(s==1?t[0][Fe]:t[Xt][0][Fe],L,Q,0),$n=on==null?-10:P(on,s==1?M[qe.scale]:M[qe.facets[1].scale],lt,0);if(Qt&&on!=null){let gi=L.ori==1?Xe:Ke,Ei=wn(Bt.dist(i,Xt,Fe,$n,gi));if(Ei<us){let $i=Bt.bias;if($i!=0){let ri=Xi(gi,qe.scale),_i=on>=0?1:-1,Ai=ri>=0?1:-1;Ai==_i&&(Ai==1?$i==1?on>=ri:on<=ri:$i==1?on<=ri:on>=ri)&&(us=Ei,Ds=Xt)}else us=Ei,Ds=Xt}}if(pt||Rt){let gi,Ei;L.ori==0?(gi=si,Ei=$n):(gi=$n,Ei=si);let $i,ri,_i,Ai,qi,qn,oi=!0,lr=ct.bbox;if(lr!=null){oi=!1;let Yn=lr(i,Xt);_i=Yn.left,Ai=Yn.top,$i=Yn.width,ri=Yn.height}else _i=gi,Ai=Ei,$i=ri=ct.size(i,Xt);if(qn=ct.fill(i,Xt),qi=ct.stroke(i,Xt),Rt)Xt==Ds&&us<=Bt.prox&&(Ut=_i,Ot=Ai,oe=$i,Ae=ri,Te=oi,xe=qn,Kt=qi);else{let Yn=he[Xt];Yn!=null&&(We[Xt]=_i,Wn[Xt]=Ai,xg(Yn,$i,ri,oi),gg(Yn,qn,qi),rs(Yn,wi(_i),wi(Ai),z,Pt))}}}}if(Rt){let Xt=Bt.prox,qe=or==null?us<=Xt:us>Xt||Ds!=or;if(pt||qe){let rn=he[0];rn!=null&&(We[0]=Ut,Wn[0]=Ot,xg(rn,oe,Ae,Te),gg(rn,xe,Kt),rs(rn,wi(Ut),wi(Ot),z,Pt))}}}if($e.show&&Is)if(x!=null){let[dt,yt]=pn.scales,[Nt,Ut]=pn.match,[Ot,oe]=x.cursor.sync.scales,Ae=x.cursor.drag;if(En=Ae._x,An=Ae._y,En||An){let{left:Te,top:xe,width:Kt,height:Xt}=x.select,qe=x.scales[Ot].ori,rn=x.posToVal,Rn,Fe,on,si,$n,gi=dt!=null&&Nt(dt,Ot),Ei=yt!=null&&Ut(yt,oe);gi&&En?(qe==0?(Rn=Te,Fe=Kt):(Rn=xe,Fe=Xt),on=M[dt],si=G(rn(Rn,Ot),on,Q,0),$n=G(rn(Rn+Fe,Ot),on,Q,0),Go(zi(si,$n),wn($n-si))):Go(0,Q),Ei&&An?(qe==1?(Rn=Te,Fe=Kt):(Rn=xe,Fe=Xt),on=M[yt],si=P(rn(Rn,oe),on,lt,0),$n=P(rn(Rn+Fe,oe),on,lt,0),Ho(zi(si,$n),wn($n-si))):Ho(0,lt)}else kh()}else{let dt=wn(pd-fd),yt=wn(md-dd);if(L.ori==1){let oe=dt;dt=yt,yt=oe}En=Un.x&&dt>=Un.dist,An=Un.y&&yt>=Un.dist;let Nt=Un.uni;Nt!=null?En&&An&&(En=dt>=Nt,An=yt>=Nt,!En&&!An&&(yt>dt?An=!0:En=!0)):Un.x&&Un.y&&(En||An)&&(En=An=!0);let Ut,Ot;En&&(L.ori==0?(Ut=Or,Ot=Xe):(Ut=Br,Ot=Ke),Go(zi(Ut,Ot),wn(Ot-Ut)),An||Ho(0,lt)),An&&(L.ori==1?(Ut=Or,Ot=Xe):(Ut=Br,Ot=Ke),Ho(zi(Ut,Ot),wn(Ot-Ut)),En||Go(0,Q)),!En&&!An&&(Go(0,0),Ho(0,0))}if(Un._x=En,Un._y=An,x==null){if(I){if(Cd!=null){let[dt,yt]=pn.scales;pn.values[0]=dt!=null?Xi(L.ori==0?Xe:Ke,dt):null,pn.values[1]=yt!=null?Xi(L.ori==1?Xe:Ke,yt):null}Xo(Af,i,Xe,Ke,z,Pt,U)}if(Qt){let dt=I&&pn.setSeries,yt=Bt.prox;or==null?us<=yt&&Wi(Ds,zr,!0,dt):us>yt?Wi(null,zr,!0,dt):Ds!=or&&Wi(Ds,zr,!0,dt)}}pt&&(ft.idx=U,Fh()),b!==!1&&Cn("setCursor")}let Ns=null;Object.defineProperty(i,"rect",{get(){return Ns==null&&Wo(!1),Ns}});function Wo(x=!1){x?Ns=null:(Ns=g.getBoundingClientRect(),Cn("syncRect",Ns))}function xd(x,b,I,U,$,Q,lt){ut._lock||Is&&x!=null&&x.movementX==0&&x.movementY==0||(Oh(x,b,I,U,$,Q,lt,!1,x!=null),x!=null?ar(null,!0,!0):ar(b,!0,!1))}function Oh(x,b,I,U,$,Q,lt,dt,yt){if(Ns==null&&Wo(!1),jt(x),x!=null)I=x.clientX-Ns.left,U=x.clientY-Ns.top;else{if(I<0||U<0){Xe=-10,Ke=-10;return}let[Nt,Ut]=pn.scales,Ot=b.cursor.sync,[oe,Ae]=Ot.values,[Te,xe]=Ot.scales,[Kt,Xt]=pn.match,qe=b.axes[0].side%2==1,rn=L.ori==0?z:Pt,Rn=L.ori==1?z:Pt,Fe=qe?Q:$,on=qe?$:Q,si=qe?U:I,$n=qe?I:U;if(Te!=null?I=Kt(Nt,Te)?a(oe,M[Nt],rn,0):-10:I=rn*(si/Fe),xe!=null?U=Xt(Ut,xe)?a(Ae,M[Ut],Rn,0):-10:U=Rn*($n/on),L.ori==1){let gi=I;I=U,U=gi}}yt&&(b==null||b.cursor.event.type==Af)&&((I<=1||I>=z-1)&&(I=wr(I,z)),(U<=1||U>=Pt-1)&&(U=wr(U,Pt))),dt?(fd=I,dd=U,[Or,Br]=ut.move(i,I,U)):(Xe=I,Ke=U)}let Bh={width:0,height:0,left:0,top:0};function kh(){Ja(Bh,!1)}let vd,yd,Sd,Md;function bd(x,b,I,U,$,Q,lt){Is=!0,En=An=Un._x=Un._y=!1,Oh(x,b,I,U,$,Q,lt,!0,!1),x!=null&&(be(Cf,Df,wd,!1),Xo(cg,i,Or,Br,z,Pt,null));let{left:dt,top:yt,width:Nt,height:Ut}=$e;vd=dt,yd=yt,Sd=Nt,Md=Ut}function wd(x,b,I,U,$,Q,lt){Is=Un._x=Un._y=!1,Oh(x,b,I,U,$,Q,lt,!1,!0);let{left:dt,top:yt,width:Nt,height:Ut}=$e,Ot=Nt>0||Ut>0,oe=vd!=dt||yd!=yt||Sd!=Nt||Md!=Ut;if(Ot&&oe&&Ja($e),Un.setScale&&Ot&&oe){let Ae=dt,Te=Nt,xe=yt,Kt=Ut;if(L.ori==1&&(Ae=yt,Te=Ut,xe=dt,Kt=Nt),En&&Ls(E,Xi(Ae,E),Xi(Ae+Te,E)),An)for(let Xt in M){let qe=M[Xt];Xt!=E&&qe.from==null&&qe.min!=Ve&&Ls(Xt,Xi(xe+Kt,Xt),Xi(xe,Xt))}kh()}else ut.lock&&(ut._lock=!ut._lock,ar(b,!0,x!=null));x!=null&&(_n(Cf,Df),Xo(Cf,i,Xe,Ke,z,Pt,null))}function w_(x,b,I,U,$,Q,lt){if(ut._lock)return;jt(x);let dt=Is;if(Is){let yt=!0,Nt=!0,Ut=10,Ot,oe;L.ori==0?(Ot=En,oe=An):(Ot=An,oe=En),Ot&&oe&&(yt=Xe<=Ut||Xe>=z-Ut,Nt=Ke<=Ut||Ke>=Pt-Ut),Ot&&yt&&(Xe=Xe<Or?0:z),oe&&Nt&&(Ke=Ke<Br?0:Pt),ar(null,!0,!0),Is=!1}Xe=-10,Ke=-10,nt.fill(null),ar(null,!0,!0),dt&&(Is=dt)}function Td(x,b,I,U,$,Q,lt){ut._lock||(jt(x),Vo(),kh(),x!=null&&Xo(fg,i,Xe,Ke,z,Pt,null))}function Ed(){A.forEach(zT),B(i.width,i.height,!0)}Ar(_h,Co,Ed);let Vr={};Vr.mousedown=bd,Vr.mousemove=xd,Vr.mouseup=wd,Vr.dblclick=Td,Vr.setSeries=(x,b,I,U)=>{let $=pn.match[2];I=$(i,b,I),I!=-1&&Wi(I,U,!0,!1)},mt&&(be(cg,g,bd),be(Af,g,xd),be(hg,g,x=>{jt(x),Wo(!1)}),be(ug,g,w_),be(fg,g,Td),Vf.add(i),i.syncRect=Wo);let Ka=i.hooks=n.hooks||{};function Cn(x,b,I){Xn?Ne.push([x,b,I]):x in Ka&&Ka[x].forEach(U=>{U.call(null,i,b,I)})}(n.plugins||[]).forEach(x=>{for(let b in x.hooks)Ka[b]=(Ka[b]||[]).concat(x.hooks[b])});let Ad=(x,b,I)=>I,pn=gn({key:null,setSeries:!1,filters:{pub:bg,sub:bg},scales:[E,y[1]?y[1].scale:null],match:[wg,wg,Ad],values:[null,null]},ut.sync);pn.match.length==2&&pn.match.push(Ad),ut.sync=pn;let Cd=pn.key,zh=y0(Cd);function Xo(x,b,I,U,$,Q,lt){pn.filters.pub(x,b,I,U,$,Q,lt)&&zh.pub(x,b,I,U,$,Q,lt)}zh.sub(i);function T_(x,b,I,U,$,Q,lt){pn.filters.sub(x,b,I,U,$,Q,lt)&&Vr[x](null,b,I,U,$,Q,lt)}i.pub=T_;function E_(){zh.unsub(i),Vf.delete(i),Tn.clear(),Ff(_h,Co,Ed),c.remove(),Ct?.remove(),Cn("destroy")}i.destroy=E_;function Vh(){Cn("init",n,t),zo(t||n.data,!1),W[E]?Dh(E,W[E]):Vo(),rt=$e.show&&($e.width>0||$e.height>0),it=pt=!0,B(n.width,n.height)}return y.forEach(Ir),A.forEach(as),e?e instanceof HTMLElement?(e.appendChild(c),Vh()):e(i,Vh):Vh(),i}Dn.assign=gn;Dn.fmtNum=Yf;Dn.rangeNum=xh;Dn.rangeLog=Sh;Dn.rangeAsinh=$f;Dn.orient=Rr;Dn.pxRatio=Re;Dn.join=Iw;Dn.fmtDate=Jf,Dn.tzDate=Gw;Dn.sync=y0;{Dn.addGap=wT,Dn.clipGaps=wh;let n=Dn.paths={points:E0};n.linear=C0,n.stepped=AT,n.bars=CT,n.spline=PT}var id=16,VT=6,L0=6,Ch=class{constructor(){this.element=k("div",{class:"mark-labels","aria-hidden":"true"})}show(t,e,[i,s],r){let a=t.filter(u=>u.label&&e(u.at)>=i-1&&e(u.at)<=s+1).map(u=>({element:k("span",{class:"mark-label",text:u.label}),x:e(u.at)}));this.element.replaceChildren(...a.map(u=>u.element)),a.forEach(u=>{u.wide=Math.min(u.element.getBoundingClientRect().width,r)});let l=[];for(let u of a){u.from=Math.max(Math.min(u.x,r-u.wide),0);let f=l.findIndex(h=>h+VT<=u.from);u.row=f<0?l.length:f,l[u.row]=u.from+u.wide}let c=Math.min(l.length,L0);this.element.style.height=`${c*id}px`;for(let{element:u,row:f,from:h,x:d}of a){u.hidden=f>=L0,u.style.left=`${h.toFixed(1)}px`,u.style.top=`${(c-1-f)*id}px`;let g=k("span",{class:"mark-pole"});g.style.left=`${d.toFixed(1)}px`,g.style.top=`${(c-f)*id-2}px`,u.hidden||this.element.prepend(g)}}};var D0="12px system-ui, sans-serif",GT=[1,10,100,1e3,1e4,1e5].flatMap(n=>[1,2,5].map(t=>t*n));function Nn({title:n,text:t,x:e,xLabel:i,yLabel:s,series:r,marks:o=()=>[],needle:a=()=>null,height:l=240,onClick:c,zero:u=!0,right:f=null,names:h=null,whole:d=!1}){let g=k("div",{class:"plot"}),v=k("ul",{class:"legend"}),m=o().some(O=>O.label)?new Ch:null,p=k("figure",{class:"curves"},k("figcaption",{text:n}),v,m?.element??[],k("div",{role:"img","aria-label":t},g)),y=k("div",{class:"needle",hidden:!0}),A=null,M=r,R=!0,E=!1,_=(O,N)=>({label:O,labelSize:22,size:N,font:D0,labelFont:D0,stroke:()=>ze("muted"),grid:{stroke:()=>ze("line"),width:1},ticks:{stroke:()=>ze("line"),width:1}});function T(O){let N=M.map(J=>({label:J.label,stroke:()=>ze(J.colour),width:J.dots||J.bars?0:J.width??2,dash:J.dash,paths:J.dots?()=>null:J.bars?Dn.paths.bars({size:[.6,9]}):void 0,fill:J.bars?()=>ze(J.colour):void 0,spanGaps:!J.gaps,points:{show:!!J.dots,size:J.size??5,fill:()=>ze(J.colour),stroke:()=>ze(J.colour),width:0}}));return{width:O,height:l,padding:m?[5,null,null,null]:void 0,legend:{show:!1},cursor:{drag:{x:!0,y:!1},points:{show:!M.some(J=>J.dots)}},scales:{x:{time:!1,...h&&{range:[.5,h.length-1.5]},...d&&{range:(J,X,Z)=>[X-.5,Z+.5]}},y:{range:(J,X,Z)=>HT(X,Z,u)}},axes:[{..._(i,34),...d&&{incrs:GT},...h&&{splits:()=>h.map((J,X)=>X).filter(J=>h[J]!==""),values:(J,X)=>X.map(Z=>h[Z])}},{..._(s,52),values:N0},...f?[{..._(f.label,64),side:1,grid:{show:!1},values:(J,X)=>N0(J,X.map(Z=>Number((Z*f.factor).toPrecision(2))))}]:[]],series:[{},...N],hooks:{drawAxes:[V],draw:[L,D],setScale:m?[F]:[],ready:m?[F]:[]}}}function V({ctx:O,bbox:N,valToPos:J}){for(let X of o().filter(Z=>Z.shade)){let[Z,nt]=[X.at,X.to].map(ft=>Math.min(Math.max(J(ft,"x",!0),N.left),N.left+N.width));O.save(),O.fillStyle=ze(X.shade),O.fillRect(Z,N.top,nt-Z,N.height),O.restore()}}function F(O){let N=O.over.offsetLeft;m.show(o(),J=>N+O.valToPos(J,"x"),[N,N+O.over.clientWidth],g.clientWidth)}function L(O){let{ctx:N,bbox:J}=O;N.save();for(let X of o().filter(Z=>Z.colour)){let Z=Math.round(O.valToPos(X.at,"x",!0))+.5;Z<J.left||Z>J.left+J.width||(N.strokeStyle=ze(X.colour),N.setLineDash(X.dash??[]),N.lineWidth=X.width??1,N.beginPath(),N.moveTo(Z,J.top),N.lineTo(Z,J.top+J.height),N.stroke())}N.restore()}function D(){let O=a(),N=O===null?NaN:A?.valToPos(O,"x")??NaN;y.hidden=!(N>=0&&N<=A.over.clientWidth),y.hidden||(y.style.transform=`translateX(${N.toFixed(1)}px)`)}function G(){let O=g.clientWidth;O!==0&&(A?.destroy(),A=new Dn(T(O),[e,...M.map(N=>N.values)],g),A.over.append(y),c&&A.over.addEventListener("click",()=>{A.cursor.idx!==null&&A.cursor.idx!==void 0&&c(e[A.cursor.idx],A.cursor.idx)}),v.replaceChildren(...M.filter(N=>N.label).map(N=>k("li",{},WT(N),N.label))))}let P=$o(G),W=()=>{E=!R,R&&A?.redraw(!1)};return ss(W),new IntersectionObserver(([O])=>{R=O.isIntersecting,R&&E&&W()}).observe(g),addEventListener("beforeprint",()=>{E&&A?.redraw(!1)}),new ResizeObserver(()=>{A&&A.width===g.clientWidth||P()}).observe(g),{element:p,follow:$o(D),show(O){let N=O.length===M.length&&O.every((J,X)=>J.label===M[X].label);M=O,N?A?.setData([e,...M.map(J=>J.values)]):P()}}}var N0=(n,t)=>t.map(e=>String(Number(e.toPrecision(6))));function HT(n,t,e){if(!Number.isFinite(n)||!Number.isFinite(t))return[0,1];let[i,s]=e?[Math.min(n,0),Math.max(t,0)]:[n,t],r=Math.max((s-i)*.06,1e-6);return[e&&n>=0?0:i-r,e&&t<=0?0:s+r]}function WT(n){let t=k("span",{class:`swatch${n.dots?" dot":""}${n.dash?" dash":""}`,"aria-hidden":"true"});return t.style.setProperty("--swatch",`var(--${n.colour})`),t}var U0=240,XT=4e3;function F0(n){return Zt("curves","Errors and corrections","Curves",k("div",{class:"plots"},qT(n),YT(n),ZT(n),JT(n)))}function $T({course:n,correction:t}){let e=Array.from({length:U0+1},(s,r)=>n.end*r/U0),i=t.buckets.slice(1).flatMap(s=>[s.from_min-1e-6,s.from_min]);return[...new Set([...e,...i.filter(s=>s<n.end)])].sort((s,r)=>s-r)}var O0=n=>n.byTemperature?"degrees Celsius":"warm-up minute";function qT(n){let{course:t,correction:e,data:i,view:s,state:r}=n,o=$T(n),a=Id(t,e,o),l=a.after??o.map(()=>i.worst_after_mm),c=s.claims?.points??[],u=o.map(d=>null);for(let[d,g]of c){let v=o.reduce((m,p,y)=>Math.abs(p-d)<Math.abs(o[m]-d)?y:m,0);u[v]=g}let f=()=>{let d=r.point,g=d===null?[]:[{label:"chosen target",colour:"before",dash:[5,4],width:1.5,values:o.map(v=>xi(t.error(d,t.at(v))))},e.inBuckets&&{label:"chosen target, corrected",colour:"after",dash:[5,4],width:1.5,values:o.map(v=>xi(t.error(d,e.leftShares(v))))}].filter(Boolean);return[{label:"worst target, uncorrected",colour:"before",values:a.before},{label:a.after?"worst target, corrected":"corrected, at worst over all minutes",colour:"after",values:l},...g,...c.length>0?[{label:s.claims.text,colour:"claim",dots:!0,size:8,values:u}]:[]]},h=Nn({title:"Error of the TCP over the warm-up",x:o.map(d=>d+t.from),xLabel:O0(t),yLabel:"mm",text:`Worst error uncorrected up to ${At(i.worst_before_mm)} mm, corrected up to ${At(i.worst_after_mm)} mm`,series:f(),needle:()=>r.t+t.from,onClick:d=>r.set({t:Math.round(d-t.from)}),height:280});return r.on("t",h.follow),r.on("point",()=>h.show(f())),h.element}function YT({course:n,correction:t,state:e,data:i}){let s=n.t,r=n.count>0?e.point??0:0,o=xi(n.error(r,n.at(n.end)))||1,a=n.nodes===1?n.shares[0]:s.map(u=>xi(n.error(r,n.at(u)))/o),l=t.buckets.slice(1).map(u=>u.from_min+n.from),c=Nn({title:t.inBuckets?`Share of the drift, and the ${t.buckets.length} buckets`:"Share of the drift",x:s.map(u=>u+n.from),xLabel:O0(n),yLabel:"share",text:`The share of the settled drift over the warm-up${t.inBuckets?` and the borders of ${t.buckets.length} buckets`:""}`,series:[{label:"share that has come",colour:"text",values:a},...l.length?[{label:"border of two buckets",colour:"bucket",values:s.map(()=>null),dash:[3,3]}]:[]],marks:()=>l.map(u=>({at:u,colour:"bucket",dash:[3,3]})),needle:()=>e.t+n.from,onClick:u=>e.set({t:Math.round(u-n.from)}),height:280});return e.on("t",c.follow),c.element}function B0(n){let t=Math.max(Math.ceil(n.count/XT),1);return Array.from({length:Math.ceil(n.count/t)},(e,i)=>i*t)}function ZT({course:n,motions:t,state:e,data:i}){let s=B0(n),r=l=>t.get(n.points.motion[l]),o=s.length<=400,a=Nn({title:"Correction of each target, in the order of the program",x:s.map(l=>l+1),xLabel:"target",whole:!0,yLabel:"mm",text:`Corrections of ${s.length} targets`,series:[{label:"largest correction",colour:"before",dots:o,values:s.map(l=>r(l)?.max_correction_mm??null)},{label:"error left at worst",colour:"after",dots:o,values:s.map(l=>r(l)?.after_mm??null)},{label:"path, off between targets",colour:"claim",dots:o,values:s.map(l=>r(l)?.mid_path_mm??null)}],needle:()=>e.point===null?null:e.point+1,onClick:(l,c)=>e.set({point:s[c]})});return e.on("point",a.follow),a.element}function JT({course:n,state:t,motions:e}){let i=B0(n),s=Nn({title:"Joints at the targets",x:i.map(r=>r+1),xLabel:"target",whole:!0,yLabel:"deg",zero:!1,text:`Nominal joints at ${i.length} targets`,series:[1,2,3,4,5,6].map(r=>({label:`J${r}`,colour:`joint-${r}`,width:1.5,dots:i.length===1,values:i.map(o=>n.points.q_deg[6*o+r-1])})),needle:()=>t.point===null?null:t.point+1,onClick:(r,o)=>t.set({point:i[o]})});return t.on("point",s.follow),s.element}var Rh=40;function tn({caption:n,columns:t,rows:e,onRow:i,name:s,sort:r,empty:o="nothing here",searchable:a=!0,rowClass:l}){let c=e,u=r??null,f=0,h=null,d=new Map,g="",v=new Array(e.length),m=new Map(e.map((O,N)=>[O,N])),p=O=>{let N=m.get(O);return v[N]??=t.map(J=>J.text(O)).join("").toLowerCase(),v[N]},y=k("tbody"),A=k("p",{class:"status",role:"status"}),M=Mi("Previous",()=>G(-1),{class:"small"}),R=Mi("Next",()=>G(1),{class:"small"}),E=t.map(O=>{let N=k("span",{class:"mark","aria-hidden":"true"}),J=k("th",{scope:"col",class:O.number?"number":""},k("button",{type:"button",class:"sort",onclick:()=>D(O)},O.label,N));return{column:O,heading:J,mark:N}});function _(O){return t.map((N,J)=>{let X=N.text(O),Z=J===0&&i?k("button",{type:"button",class:"link",text:X||Fn,onclick:()=>i(O)}):X;return k("td",{class:`${N.number?"number":""} ${N.class??""}`.trim(),title:String(X).length>24?X:void 0},Z)})}function T(O){let N=d.get(O);N&&(N.classList.toggle("chosen",O===h),O===h?N.setAttribute("aria-current","true"):N.removeAttribute("aria-current"))}function V(O,N){d=new Map(c.slice(O,N).map(J=>[J,k("tr",{class:l?.(J)||void 0,onclick:i?X=>{X.target.tagName!=="BUTTON"&&i(J)}:void 0},_(J))])),y.replaceChildren(...d.values()),T(h),c.length===0&&y.append(k("tr",{},k("td",{colSpan:t.length,class:"empty",text:e.length?"no row matches":o})))}function F(){let O=Math.max(Math.ceil(c.length/Rh),1);f=Math.min(Math.max(f,0),O-1),V(f*Rh,(f+1)*Rh);let N=c.length===e.length?we(e.length,"row"):`${ne(c.length)} of ${we(e.length,"row")}`;A.textContent=O>1?`${N}, page ${ne(f+1)} of ${ne(O)}`:N,M.disabled=f===0,R.disabled=f>=O-1,P.hidden=O<2;for(let{column:J,heading:X,mark:Z}of E){let nt=u?.key===J.key?u.up:null;X.setAttribute("aria-sort",nt===null?"none":nt?"ascending":"descending"),Z.textContent=nt===null?"":nt?" \u25B2":" \u25BC"}}function L(){c=g?e.filter(N=>p(N).includes(g)):[...e];let O=u&&t.find(N=>N.key===u.key);if(O){let N=c.map(X=>[O.value(X),X]),J=(X,Z)=>X===Z?0:X==null?1:Z==null?-1:(X<Z?-1:1)*(u.up?1:-1);N.sort((X,Z)=>J(X[0],Z[0])),c=N.map(([,X])=>X)}F()}function D(O){let N=!O.number;u=u?.key===O.key?{key:O.key,up:!u.up}:{key:O.key,up:N},f=0,L()}function G(O){f+=O,F()}let P=k("div",{class:"pager"},M,R),W=a&&e.length>8?Oa({label:`Search ${n.toLowerCase()}`,name:`${s}-search`,on:O=>{g=O.trim().toLowerCase(),f=0,L()}}):null;return W&&tl(e.length,O=>p(e[O])),addEventListener("beforeprint",()=>{V(0,br),A.textContent=uh(c.length,e.length,"row")}),addEventListener("afterprint",F),L(),{element:k("div",{class:"table","data-name":s},k("div",{class:"bar"},W,A,P),k("div",{class:"scroll",tabIndex:0,role:"group","aria-label":n},k("table",{},k("caption",{class:"hidden",text:n}),k("thead",{},k("tr",{},E.map(O=>O.heading))),y))),choose(O){if(O===h)return;let N=h;h=O;let J=c.indexOf(O);J>=0&&!d.has(O)&&(f=Math.floor(J/Rh),F()),T(N),T(O)}}}var er=n=>n==null?"":String(n),nr=(n,t,e=4)=>({key:n,label:t,number:!0,value:i=>i[n],text:i=>At(i[n],e)}),k0=n=>{let t=e=>e.status==="compensated"?e:{};return{...n,value:e=>n.value(t(e)),text:e=>n.text(t(e))}};function z0(n){let{data:t,view:e,course:i,state:s}=n,r=new Set(t.motions.map(h=>h.file)).size>1,o=[{key:"target",label:"target",value:h=>h.target??h.line,text:h=>wf(h),class:"name"},r&&{key:"file",label:"file",value:h=>h.file,text:h=>er(h.file),class:"name"},{key:"line",label:"line",number:!0,value:h=>h.line,text:h=>er(h.line)},{key:"routine",label:"routine",value:h=>h.routine,text:h=>er(h.routine),class:"name"},{key:"kind",label:"move",value:h=>h.kind,text:h=>er(h.kind)},{key:"status",label:"status",value:h=>h.status,text:h=>h.status==="compensated"?er(h.form):`${h.status}: ${er(h.reason)}`,class:"reason"},k0(nr("max_correction_mm","correction mm")),k0(nr("max_correction_deg","deg",5)),nr("mid_path_mm","mid-path mm"),nr("before_mm","before mm"),nr("after_mm","after mm")].filter(Boolean),a={refused:0,kept:1,compensated:2},l=[...t.motions].sort((h,d)=>a[h.status]-a[d.status]),c=new Map;i?.points.motion.forEach((h,d)=>{c.has(h)||c.set(h,d)});let u=tn({caption:"Motions",name:"motions",columns:o,rows:l,empty:"the program has no motion",rowClass:h=>h.status,onRow:i?f:void 0});function f(h){let d=c.get(h.index);d!==void 0&&s.set({point:d}),u.choose(h)}return i&&s.on("point",()=>u.choose(n.motions.get(i.points.motion[s.point])??null)),Zt("motions","Motions","Motions",u.element,e.routines&&KT(e.routines))}function KT(n){let t=[{key:"routine",label:"routine",value:e=>e.routine,text:e=>er(e.routine),class:"name"},{key:"file",label:"file",value:e=>e.file,text:e=>er(e.file),class:"name"},{key:"motions",label:"motions",number:!0,value:e=>e.motions,text:e=>ne(e.motions)},{key:"compensated",label:"compensated",number:!0,value:e=>e.compensated,text:e=>ne(e.compensated)},nr("max_correction_mm","largest correction mm"),nr("before_mm","before mm"),nr("after_mm","after mm")];return k("div",{},k("h3",{text:"All motions by routine"}),tn({caption:"Routines",name:"routines",columns:t,rows:n}).element)}var jT=.75;function V0({data:n,view:t,version:e}){let i=n.errors.length>0,s=t.course&&t.points.motion.length>0?new el(t):null,r=s&&new nl(s,n),o=s&&iE(s),a={data:n,view:t,course:s,correction:r,motions:new Map(n.motions.map(f=>[f.index,f])),state:Gr({t:s?Math.round(s.end*jT):0,times:20,point:o,corrected:!1,joints:s?.joints(o)??null})},l=t.totals??QT(n.motions),c=[()=>tE(n,t,l,i),()=>s&&rg(a),()=>s&&!i&&F0(a),()=>n.motions.length>0&&z0(a),()=>t.source&&t.source.files.length>0&&tg(a),()=>Hn(nE(t),e)];return{kind:"compensation",verdict:i?"Refused: nothing was written":`${we(l.motions,"motion")}: ${ne(l.compensated)} compensated, ${ne(l.kept)} kept`,tone:i?"bad":l.kept>0||n.warnings.length>0?"warn":"good",sections:c}}var QT=n=>{let t=e=>n.filter(i=>i.status===e).length;return{motions:n.length,compensated:t("compensated"),kept:t("kept"),refused:t("refused")}};function tE(n,t,e,i){let s=n.buckets.length,r=[i&&[k("h3",{text:"Refused"}),Oi(n.errors,"bad")],n.warnings.length>0&&[k("h3",{text:we(n.warnings.length,"warning")}),Oi(n.warnings,"warn")],!i&&n.warnings.length===0&&k("p",{class:"calm",text:"No refusals, no warnings."})],o=(n.other_tolerances??[]).map(a=>`${a.tolerance_mm} mm ${a.buckets}`).join(", ");return Zt("overview","Overview","Overview",r,n.worst_before_mm!==null&&Gn(e.compensated>0&&[se("Worst error, uncorrected",At(n.worst_before_mm),"mm","any corrected target, any minute","before"),se("Worst error, corrected",At(n.worst_after_mm,n.worst_after_mm<5e-4?6:4),"mm","any corrected target, any minute","after")],se("Motions",ne(e.motions),"",`${ne(e.compensated)} compensated, ${ne(e.kept)} kept, ${ne(e.refused)} refused`),s>0?se("Buckets",ne(s),"",o&&`at other tolerances: ${o}`):se("Form",eE(e),"","scaled at run time, no buckets"),e.compensated>0&&s>0&&se("Largest step between buckets",At(n.worst_switch_jump_mm),"mm","of the TCP"),e.compensated>0&&se("One work-object shift instead",At(n.rigid_shift_worst_mm),"mm","would be left at worst")),t.shown&&k("p",{class:"notice",text:`${ne(e.motions)} motions are too many for one page: it holds ${ne(t.shown)} of them: up to 10,000 that are kept or refused, and those with the largest corrections. Figures above and sums of routines are over all.`}),t.from_json&&k("p",{class:"notice",text:"Made from JSON alone: arm, curves and source are on the page that `compensate --report` writes."}))}function eE(n){return Object.entries(n.by_form??{}).filter(([,e])=>e>0).map(([e])=>e).join(", ")||Fn}var nE=n=>[...n.provenance??[],...n.settings??[]];function iE(n){let t=n.at(n.end),[e,i]=[null,-1];for(let s=0;s<n.count;s+=1){let r=Math.hypot(...n.error(s,t));r>i&&([e,i]=[s,r])}return e}var sE=99;function os({label:n,rows:t,most:e}){let i=o=>Math.min(Math.max(o/e,0),1)*sE,s=o=>k("div",{class:"bar-row"},k("span",{class:"bar-name",text:o.label})," ",k("span",{class:"bar-value",text:o.text}),ja("svg",{width:"100%",height:12,"aria-hidden":"true"},ja("rect",{x:0,y:0,width:`${Math.max(i(o.value),.3)}%`,height:12,class:`bar-${o.colour??"plain"}`,rx:1.5}),o.interval?[ja("line",{x1:`${i(o.interval[0])}%`,x2:`${i(o.interval[1])}%`,y1:6,y2:6,class:"bar-interval"})]:[])),r=t.map(o=>`${o.label} ${o.text}`).join("; ");return k("div",{class:"bars",role:"img","aria-label":`${n}: ${r}`},t.map(s))}var G0=(n,t)=>Math.hypot(n[3*t],n[3*t+1],n[3*t+2]);function sd(n){let t=n.q_deg.length/n.line.length;return n.line.map((e,i)=>({i,line:e,id:n.id[i],t:n.t_min[i],outlier:n.outlier[i]===1,q:n.q_deg.slice(t*i,t*(i+1)),before:G0(n.before_mm,i),after:G0(n.after_mm,i)}))}function W0(n){let t=sd(n.view.residuals);n.rows=t;let e=t.filter(u=>!u.outlier),i=e.length>0&&e.every(u=>u.t!==null),{joint:s}=n.view.robot,r=s.map((u,f)=>f).filter(u=>new Set(e.map(f=>f.q[u])).size>1),o=[H0(e,{title:i?"Over time":"In the order of the rows",xLabel:i?"minutes":"line of the file",of:u=>i?u.t:u.line},n),...r.map(u=>{let f=s[u].type==="prismatic";return H0(e,{title:`By the ${f?"travel":"angle"} of joint ${u+1}`,xLabel:f?"mm":"deg",of:h=>h.q[u]},n)})],a=[{key:"line",label:"line",number:!0,value:u=>u.line,text:u=>String(u.line)},{key:"id",label:"id",value:u=>u.id,text:u=>u.id??"",class:"name"},i&&{key:"t",label:"min",number:!0,value:u=>u.t,text:u=>u.t===null?Fn:String(u.t)},{key:"before",label:"before mm",number:!0,value:u=>u.before,text:u=>At(u.before,3)},{key:"after",label:"after mm",number:!0,value:u=>u.after,text:u=>At(u.after,3)},{key:"outlier",label:"set aside",value:u=>u.outlier?1:0,text:u=>u.outlier?"false row":""}].filter(Boolean),l=tn({caption:"Rows",name:"rows",columns:a,rows:t,sort:{key:"before",up:!1},rowClass:u=>u.outlier?"refused":"",onRow:u=>n.state.set({row:u.i})});n.state.on("row",()=>l.choose(t[n.state.row]??null));let c=t.length<n.view.rows?k("p",{class:"notice",text:`Every ${Math.ceil(n.view.rows/t.length)}th of ${n.view.rows} rows is shown.`}):null;return Zt("residuals","Distance from the model, row by row","Residuals",k("div",{class:"plots three"},o.map(u=>u.element)),c,l.element)}function H0(n,{title:t,xLabel:e,of:i},{state:s}){let r=[...n].sort((a,l)=>i(a)-i(l)),o=Nn({title:t,x:r.map(i),xLabel:e,yLabel:"mm",height:210,text:`${t}: distance from the model of ${n.length} rows before and after`,series:[{label:"before",colour:"before",dots:!0,size:4,values:r.map(a=>a.before)},{label:"after",colour:"after",dots:!0,size:4,values:r.map(a=>a.after)}],needle:()=>{let a=n.find(l=>l.i===s.row);return a?i(a):null},onClick:(a,l)=>s.set({row:r[l].i})});return s.on("row",o.follow),o}var od=2e3,ad=200,X0=n=>Math.round(od**(n/ad)),rE=n=>Math.round(Math.log(n)/Math.log(od)*ad);function $0(n){let{data:t,view:e,state:i}=n,s=e.residuals;n.rows??=sd(s);let r=lh(`Residuals of ${s.line.length} rows in the workspace and the arm in 3-D. Arrow keys with Shift turn it, plus and minus zoom, Home looks from the start again.`),o=aE(t,e,i),a=k("p",{class:"hud",role:"status"});if(!r)return Zt("workspace","In the workspace","Workspace",k("p",{class:"notice",text:"This browser draws no 3-D (WebGL is off)."}),o);let l=t.tool_mm??[0,0,0],c=new Mr(il(e.robot),{thickness:rd(e.robot)/34,transparent:!0,opacity:.55,axes:!1}),u=new wo(s.p_mm);u.path.visible=!1,r.scene.add(c.group,u.group),r.dressed(()=>{c.paint(ze("arm"),ze("arm-joint")),u.paint({path:ze("path"),ring:ze("accent")})});let f=n.rows.filter(v=>!v.outlier).map(v=>v.before).sort((v,m)=>v-m),h=Math.max(f[Math.floor(f.length*.95)]??0,1e-6);i.times=Math.min(Math.max(Math.round(rd(e.robot)*.08/h),10),od);let d=r.beforePicture(()=>{let v=i.after?s.after_mm:s.before_mm;u.show((M,R)=>{for(let E=0;E<3;E+=1)R[E]=s.outlier[M]?0:v[3*M+E]},i.times,h),u.mark(i.row);let m=i.pose===null?null:t.next_measurements[i.pose],p=i.row===null?null:n.rows[i.row],y=m?.q_deg??p?.q??n.rows[0]?.q??e.robot.joint.map(()=>0),A=c.pose(y,l).map(M=>M.toFixed(1)).join(", ");a.textContent=m?`to measure next: pose ${i.pose+1}, point at ${A} mm`:p?`line ${p.line}: ${At(p.before,3)} mm before, ${At(p.after,3)} mm after, drawn at ${A} mm`:"",a.hidden=a.textContent===""});i.on("row after times pose",d),ss(d),i.on("row",()=>{i.pose=null}),r.onPick(()=>u.dots,v=>i.set({row:v})),oE(r,s,rd(e.robot)),d(),r.canvas.windowPlace=v=>r.toWindow(s.p_mm.slice(3*v,3*v+3));let g=k("div",{class:"panel"},ch({label:"Residuals",name:"after",options:[["no","before"],["yes","after"]],value:"no",on:v=>i.set({after:v==="yes"})}),To({label:"Arrows enlarged",name:"times",min:0,max:ad,step:1,value:rE(i.times),show:v=>`${X0(v)} \xD7`,on:v=>i.set({times:X0(v)})}).element,k("p",{class:"calm",text:"Base and target are fitted in both; \u201Cafter\u201D has causes and background geometry taken off."}));return Zt("workspace","In the workspace","Workspace",k("div",{class:"stage"},k("div",{class:"screen"},r.element,a,k("p",{class:"scale"},k("span",{text:"0"}),k("span",{class:"ramp","aria-hidden":"true"}),k("span",{text:`${At(h,3)} mm`}))),g),o)}var rd=n=>[...n.joint,n.flange].reduce((t,{origin_mm:e})=>t+Math.hypot(...e),0);function oE(n,t,e){let i=[-.15*e,-.15*e,0],s=[.15*e,.15*e,.6*e];t.p_mm.forEach((r,o)=>{i[o%3]=Math.min(i[o%3],r),s[o%3]=Math.max(s[o%3],r)}),n.lookAt(i,s)}function aE(n,t,e){if(n.next_measurements.length===0)return null;let i=n.next_measurements.map((o,a)=>({...o,i:a})),s=[{key:"i",label:"pose",number:!0,value:o=>o.i,text:o=>String(o.i+1)},...i[0].q_deg.map((o,a)=>({key:`q${a}`,label:`J${a+1} ${t.robot?.joint[a].type==="prismatic"?"mm":"deg"}`,number:!0,value:l=>l.q_deg[a],text:l=>l.q_deg[a].toFixed(1)})),{key:"kg",label:"payload kg",number:!0,value:o=>o.payload_kg,text:o=>ye(o.payload_kg)},{key:"dir",label:`approach J1 to J${i[0].dir.length}`,value:o=>o.dir.join(),text:o=>o.dir.map(a=>a<0?"\u2212":"+").join(" ")}],r=tn({caption:"What to measure next",name:"next",columns:s,rows:i,searchable:!1,onRow:o=>{r.choose(o),e.set({pose:o.i})}});return k("div",{},k("h3",{class:"apart",text:`What to measure next, ${n.next_reason}`}),r.element)}var lE={1:"eccentricity",2:"second harmonic"},cE=12,hE=12;function uE(n){let t=n.filter(i=>i.effect.startsWith("gear")&&i.size!==null&&i.slot!==null);return[...new Set(t.map(i=>i.joint))].sort((i,s)=>i-s).map(i=>({joint:i,lever_mm:null,lines:t.filter(s=>s.joint===i).map(s=>({n:s.n??(s.effect==="gear_eccentricity"?1:2),named:!0,mrad:1e3*s.size,sigma_mrad:s.sigma===null?null:1e3*s.sigma})).sort((s,r)=>s.n-r.n)}))}function q0(n,t){let e=(t.spectra??[]).length>0,i=e?t.spectra:uE(n.causes);if(i.length===0)return null;let s=i.flatMap(({joint:a,lever_mm:l,lines:c})=>c.map(u=>({joint:a,...u,mm:l===null?null:u.mrad*l/1e3}))),r=(a,l)=>`${a.toFixed(4)}${l===null?"":` \xB1 ${l.toFixed(4)}`}`,o=[{key:"joint",label:"joint",number:!0,value:a=>a.joint,text:a=>String(a.joint)},{key:"n",label:"lines a turn",number:!0,value:a=>a.n,text:a=>String(a.n)},{key:"mrad",label:"mrad",number:!0,value:a=>a.mrad,text:a=>r(a.mrad,a.sigma_mrad)},{key:"mm",label:"mm at the tool",number:!0,value:a=>a.mm,text:a=>At(a.mm)},{key:"named",label:"named",value:a=>a.named?1:0,text:a=>a.named?lE[a.n]??`${a.n} a turn`:""}];return Zt("gears","Gears: lines over a turn of each joint","Gears",k("div",{class:"plots"},i.map(fE)),k("p",{class:"notice","data-name":"gears-notice",text:e?"Amplitudes of the model. A joint with three named lines or more has every line that the model fits, up to 80 a turn, which spreads what the measured part of a turn cannot tell apart; others have their named lines and overtones of them. At the tool: times the distance of the measured points from the joint\u2019s axis, rms.":"Lines of the causes; the whole spectra and their size at the tool are on the page that `diagnose --report` writes."}),tn({caption:"Lines",name:"gear-lines",columns:o,rows:s,sort:{key:"mrad",up:!1},rowClass:a=>a.named?"":"quiet"}).element)}function fE({joint:n,lever_mm:t,lines:e}){let i=Math.max(...e.map(h=>h.n),cE),s=new Map(e.map(h=>[h.n,h])),r=[0,...Array.from({length:i},(h,d)=>d+1),i+1],o=h=>r.map(d=>s.get(d)?.named===h?s.get(d).mrad:null),a=e.filter(h=>h.named).sort((h,d)=>d.mrad-h.mrad),l=a.slice(0,hE).sort((h,d)=>h.n-d.n),c=e.length>a.length,[u]=[...e].sort((h,d)=>d.mrad-h.mrad),f=t===null?"":`, ${ye(u.mrad*t/1e3)} mm at the tool`;return Nn({title:`Joint ${n}: ${e.length} ${e.length===1?"line":"lines"}, the largest ${u.n} a turn, ${ye(u.mrad)} mrad${f}`,x:r,xLabel:"lines a turn",yLabel:"mrad",height:230,right:t===null?null:{label:"mm at the tool",factor:t/1e3},text:`Gear of joint ${n}: ${a.map(h=>`${h.n} a turn ${h.mrad.toFixed(4)} mrad`).join(", ")}`,series:[{label:"named",colour:"after",bars:!0,values:o(!0)},...c?[{label:"of the spectrum beside them",colour:"bucket",bars:!0,values:o(!1)}]:[]],marks:()=>l.map(h=>({at:h.n,label:String(h.n)}))}).element}var dE={explained:["good","One cause, told apart from its rivals"],several:["good","Several causes, each needed"],ambiguous:["warn","A cause is there; these data cannot tell which of a set"],geometry:["good","Small errors of all joints, none singled out"],unexplained_structure:["warn","Structure that no effect of the library takes"],unexplained_scatter:["warn","More scatter than the repeats allow"],nothing_above_noise:["good","Nothing above the noise"],insufficient_data:["bad","Too few or too alike poses for any answer"],data_fault:["bad","The file contradicts itself or the robot"]},pE=new Set(["explained","several","ambiguous","data_fault"]),ld=n=>n.replaceAll("_"," ");function ir(n){let t=n.joint?` of joint ${n.joint}`:"",e=n.joint_b?` on joint ${n.joint_b}`:"",i=n.n&&n.effect==="gear_mesh"?`, ${n.n} per turn`:"",s=n.t0_min!==null&&n.t0_min!==void 0?` at minute ${ye(n.t0_min)}`:"";return`${ld(n.effect)}${t}${e}${i}${s}`}var Y0=n=>n>.999?"> 99.9 %":n<.001?"< 0.1 %":`${(100*n).toFixed(1)} %`,mE=n=>n.size===null?Fn:`${ye(n.size)}${n.sigma===null?"":` \xB1 ${ye(n.sigma)}`} ${n.unit==="1"?"":n.unit}`;function Z0({data:n,view:t,version:e}){let[i,s]=dE[n.verdict]??["",ld(n.verdict)],r={data:n,view:t,state:Gr({row:null,pose:null,after:!1,times:100})},o=(t.residuals?.line.length??0)>0;return{kind:"diagnosis",verdict:s,tone:i,sections:[()=>gE(n,t,i),()=>xE(n),()=>q0(n,t),()=>o&&W0(r),()=>t.robot&&(o||n.next_measurements.length>0)&&$0(r),()=>n.false_rows?.length>0&&yE(n),()=>SE(n),()=>Hn([...t.provenance??[],...t.robot?[["robot",t.robot.name]]:[]],e)]}}function gE(n,t,e){let{shrink:i,noise:s}=n,r=[{label:"before",value:i.before_rms_mm,text:`${At(i.before_rms_mm,3)} mm`,colour:"before"},i.causes_only_rms_mm!==null&&{label:"causes alone",value:i.causes_only_rms_mm,text:`${At(i.causes_only_rms_mm,3)} mm`,colour:"plain"},{label:"with the model",value:i.after_rms_mm,text:`${At(i.after_rms_mm,3)} mm`,colour:"after",interval:i.ci90&&i.ci90.map(l=>l*i.before_rms_mm)},{label:"noise",value:i.floor_rms_mm,text:`${At(i.floor_rms_mm,3)} mm`,colour:"plain"}].filter(Boolean),o=[["last part of the time",i.time_block],["a region of the workspace",i.region_block]].filter(([,l])=>l),a=Math.max(...r.map(l=>l.interval?.[1]??0),...r.map(l=>l.value));return Zt("overview","Verdict","Verdict",k("p",{class:`reason ${e}`,text:_E(n.reason)}),t.mostly&&k("p",{class:"notice","data-name":"mostly",text:t.mostly}),t.next&&k("p",{class:"next","data-name":"next-step"},k("b",{text:"Next: "}),`${t.next}.`),n.fault&&Oi([{code:"data fault",message:typeof n.fault=="string"?n.fault:Object.values(n.fault).map(String).join("; ")}],"bad"),n.warnings.length>0&&Oi(n.warnings,"warn"),Gn(se("Rows",ne(n.rows),"",we(n.stations,"station")),i.ratio!==null&&se("The gap shrinks to",`${(100*i.ratio).toFixed(0)} %`,"",i.ci90&&`${(100*i.ci90[0]).toFixed(0)} to ${(100*i.ci90[1]).toFixed(0)} %, nine times in ten`,"after"),s?.repeats_sigma_mm!==void 0&&s.repeats_sigma_mm!==null&&se("Noise in repeats",At(s.repeats_sigma_mm),"mm","of one coordinate"),s?.model_sigma_mm!==void 0&&s.model_sigma_mm!==null&&se("Noise about the best model",At(s.model_sigma_mm),"mm","of one coordinate"),n.where?.joint&&se("Where",`joint ${n.where.joint}`,"",n.where.time??void 0)),i.before_rms_mm!==null&&[k("h3",{class:"apart",text:"How much better the robot gets, on poses held out (rms, 3-D)"}),os({label:"Error on held-out poses",rows:r,most:a})],o.map(([l,c])=>k("p",{class:"calm",text:`${l} held out whole: ${At(c.before_rms_mm,3)} mm before, ${At(c.after_rms_mm,3)} mm after`})),t.from_json&&k("p",{class:"notice",text:"Made from JSON alone: residuals and the arm are on the page that `diagnose --report` writes."}),t.text&&Es("The report as printed",()=>k("pre",{class:"report",tabIndex:0,text:t.text})))}var _E=n=>n?n[0].toUpperCase()+n.slice(1)+(n.endsWith(".")?"":"."):"";function xE(n){let t=[...new Set(n.causes.map(r=>r.slot))],e=pE.has(n.verdict),i=e?"Causes":"Nearest candidates, none of them the answer";if(n.causes.length===0)return Zt("causes","Causes","Causes",k("p",{class:"calm",text:"No cause is named."}));let s=[{key:"name",label:"effect",value:ir,text:ir,class:"name"},{key:"posterior",label:"probability",number:!0,value:r=>r.posterior,text:r=>Y0(r.posterior)},{key:"size",label:"size",number:!0,value:r=>r.size,text:mE},{key:"rms",label:"tool moves, mm",number:!0,value:r=>r.rms_mm,text:r=>At(r.rms_mm,3)},{key:"seen",label:"of it seen, mm",number:!0,value:r=>r.rms_seen_mm,text:r=>At(r.rms_seen_mm,3)},{key:"evidence",label:"evidence, nats",number:!0,value:r=>r.evidence_nats,text:r=>ye(r.evidence_nats)},{key:"usual",label:"usual",value:r=>r.usual,text:r=>r.usual??"",class:"name"},{key:"source",label:"source",value:r=>r.source,text:r=>r.source??"",class:"reason"}];return Zt("causes",i,"Causes",t.map(r=>{let o=n.causes.filter(l=>l.slot===r),a=t.length>1||o.length>1?`${t.length>1?`Slot ${r}: `:""}${o.length>1?`${o.length} alternatives that these data ${e?"cannot tell apart":"leave open"}`:ir(o[0])}`:null;return[a&&k("h3",{class:"apart",text:a}),os({label:"Probability",most:1,rows:o.slice(0,12).map(l=>({label:vE(l),value:l.posterior,text:Y0(l.posterior),colour:"after"}))})]}),tn({caption:"Causes",name:"causes",columns:s,rows:n.causes,searchable:!1}).element,k("p",{class:"notice",text:"Seen: what is left of it where base and target, which are fitted, stand as well as they can beside it."}),n.rivals?.length>0&&[k("h3",{class:"apart",text:"What it is not, as far as these data tell"}),tn({caption:"Rivals",name:"rivals",columns:s,rows:n.rivals}).element])}var vE=n=>ir(n).replace(" of joint ",", J").replace("compliance","compl.").replace("eccentricity","ecc.").replace("second harmonic","2nd harm.");function yE(n){let t=[{key:"line",label:"line",number:!0,value:e=>e.line,text:e=>String(e.line)},{key:"id",label:"id",value:e=>e.id,text:e=>e.id??"",class:"name"},{key:"off",label:"off by, mm",number:!0,value:e=>e.off_mm,text:e=>At(e.off_mm,3)},{key:"like",label:"looks like",value:e=>e.looks_like,text:e=>e.looks_like??"",class:"reason"}];return Zt("false",`${we(n.false_rows.length,"row")} set aside as false`,"False rows",tn({caption:"False rows",name:"false",columns:t,rows:n.false_rows}).element)}function SE(n){let t=i=>`${ld(i.effect)}${i.joints.length?` of ${i.joints.length>1?"joints":"joint"} ${i.joints.join(", ")}`:""}`,e=[{key:"effect",label:"effect",value:ir,text:ir,class:"name"},{key:"size",label:"seen from",number:!0,value:i=>i.size,text:i=>`${ye(i.size)} ${i.unit}`}];return Zt("limits","What these data cannot tell","Limits",n.untestable_detail.length>0?k("dl",{class:"facts wide"},n.untestable_detail.map(i=>k("div",{},k("dt",{text:t(i)}),k("dd",{text:i.reason})))):k("p",{class:"calm",text:"Every effect of the library can be tested with them."}),n.detectable.length>0&&[k("h3",{class:"apart",text:"From which size on an effect would have been seen"}),tn({caption:"Detectable sizes",name:"detectable",columns:e,rows:n.detectable}).element])}var K0=n=>n.map((t,e)=>({i:e,line:t.line,point:t.point,t:t.t_min,before:Math.hypot(...t.before_mm),after:Math.hypot(...t.after_mm),of:t.after_mm,looksFalse:t.looks_false,counts:t.counts}));function j0(n,t,e){if(n.length===0)return[];let i=t.stops.map(([l,c])=>({at:l,to:c,shade:"shade",colour:"bucket",dash:[3,3],label:`stands ${ye(c-l)} min`})),s=t.points.map(l=>l.point),[r,o]=[n[0].t,n.at(-1).t],a=l=>s.indexOf(l.point)+1+.7*((l.t-r)/Math.max(o-r,1e-9)-.5);return[J0(n,e,{title:"Every touch over time",xLabel:"warm-up minute",x:l=>l.t,marks:()=>i}),J0(n,e,{title:"Every touch by point, in each from the first to the last",xLabel:"point",x:a,names:["",...s,""]})]}function J0(n,t,{title:e,xLabel:i,x:s,marks:r,names:o}){let a=[...n].sort((f,h)=>s(f)-s(h)),l=n.some(f=>f.looksFalse),c=f=>a.map(h=>f(h)??null),u=Nn({title:e,x:a.map(s),xLabel:i,yLabel:"mm",height:240,marks:r,names:o,text:`${e}: ${n.length} touches, ${At(Math.max(...n.map(f=>f.before)),3)} mm at most before, ${At(Math.max(...n.map(f=>f.after)),3)} mm after; ${n.filter(f=>f.looksFalse).map(f=>`line ${f.line} looks false`).join(", ")}`,series:[{label:"moved since the cold arm",colour:"before",dots:!0,size:5,values:c(f=>f.before)},{label:"left by the fit",colour:"after",dots:!0,size:5,values:c(f=>f.looksFalse?null:f.after)},...l?[{label:"left, looks false",colour:"bad",dots:!0,size:10,values:c(f=>f.looksFalse?f.after:null)}]:[]],needle:()=>{let f=n.find(h=>h.i===t.row);return f?s(f):null},onClick:(f,h)=>t.set({row:a[h].i})});return t.on("row",u.follow),u.element}function Q0(n,t){let i=tn({caption:"Touches",name:"touches",columns:[{key:"line",label:"line",number:!0,value:s=>s.line,text:s=>String(s.line)},{key:"point",label:"point",value:s=>s.point,text:s=>s.point,class:"name"},{key:"t",label:"min",number:!0,value:s=>s.t,text:s=>ye(s.t)},{key:"before",label:"moved mm",number:!0,value:s=>s.before,text:s=>At(s.before)},{key:"after",label:"left mm",number:!0,value:s=>s.after,text:s=>At(s.after)},{key:"of",label:"left x, y, z",value:s=>s.after,text:s=>s.of.map(r=>At(r,3)).join(", ")},{key:"false",label:"judged",value:s=>s.looksFalse?1:0,text:s=>s.looksFalse?`looks false${s.counts?"":", set aside"}`:""}],rows:n,sort:{key:"after",up:!1},rowClass:s=>s.looksFalse?"refused":"",onRow:s=>t.set({row:s.i})});return t.on("row",()=>i.choose(n[t.row]??null)),i.element}var ME=3,sr=n=>n.replaceAll("_"," ").replace(/ (mm|deg|min|kg)$/," ($1)"),rr=n=>n!==null&&typeof n=="object"&&!Array.isArray(n),bE={mm:4,deg:4,min:2},wE=n=>bE[/[ _(](mm|deg|min)\)?$/.exec(n)?.[1]];function Fo(n,t){return n==null?Fn:typeof n=="number"?t===void 0?ye(n):n.toFixed(t):typeof n=="boolean"?n?"yes":"no":Array.isArray(n)?n.length>ME&&n.every(rr)?we(n.length,"value"):n.map(e=>Fo(e,t)).join(", "):rr(n)?Object.entries(n).map(([e,i])=>`${sr(e)} ${Fo(i)}`).join("; "):String(n)}function ni(n,t){let e=t.map(a=>rr(a)?TE(a):{value:a}),i=a=>e.some(l=>Array.isArray(l[a])||rr(l[a])),s=[...new Set(e.flatMap(a=>Object.keys(a)))].filter(a=>e.some(l=>l[a]!==null)),o=[...s.filter(a=>!i(a)),...s.filter(i)].map(a=>({key:a,label:sr(a),number:e.every(l=>l[a]===null||l[a]===void 0||typeof l[a]=="number"),value:l=>rr(l[a])||Array.isArray(l[a])?Fo(l[a]):l[a],text:l=>Fo(l[a],wE(a))}));return tn({caption:sr(n),name:n,columns:o,rows:e}).element}function TE(n){return Object.fromEntries(Object.entries(n).flatMap(([t,e])=>rr(e)?Object.entries(e).map(([i,s])=>[`${t}_${i}`,s]):[[t,e]]))}function t_({command:n,data:t,view:e,version:i}){let s=Object.entries(t),r=s.filter(([,c])=>!rr(c)&&!Array.isArray(c)),o=s.filter(([,c])=>Array.isArray(c)&&c.length>0),a=s.filter(([,c])=>rr(c)),l=[Zt("overview","Overview","Overview",e.messages?.length>0&&Oi(e.messages,"warn"),Gn(r.map(([c,u])=>se(sr(c),Fo(u)))),a.map(([c,u])=>[k("h3",{text:sr(c)}),Sf(Object.entries(u).map(([f,h])=>[sr(f),Fo(h)]))])),...o.map(([c,u])=>Zt(`list-${c}`,`${sr(c)}: ${ne(u.length)}`,sr(c),ni(c,u))),Hn(e.provenance??[],i)].map(c=>()=>c);return{kind:n,verdict:null,tone:"",sections:l}}var Pr=n=>n.text&&Es("The report as printed",()=>k("pre",{class:"report",tabIndex:0,text:n.text})),e_=(n,t)=>Object.entries(t).filter(([e])=>n[e]?.length>0).map(([e,i])=>Zt(`list-${e}`,`${i}: ${ne(n[e].length)}`,i,ni(e,n[e]))),Oo=(n,t)=>Object.fromEntries(t.filter(e=>e in n).map(e=>[e,n[e]]));function EE(n){let[t,e]=n.split(":"),i=s=>s/Number(e);return{none:()=>1,exp:s=>1-Math.exp(-i(s)),"two-stage":s=>1-(1+i(s))*Math.exp(-i(s))}[t]??(()=>null)}var n_=n=>`${(100*n).toFixed(0)} %`,cd=(n,t)=>t.toFixed(n.unit==="deg"?5:4);function AE(n){let t=i=>({key:i,label:i,number:!0,value:s=>s[i],text:s=>cd(s,s[i])}),e=[{key:"joint",label:"joint",number:!0,value:i=>i.joint,text:i=>String(i.joint)},{key:"parameter",label:"parameter",value:i=>i.parameter,text:i=>i.parameter},t("value"),t("sigma"),{key:"unit",label:"unit",value:i=>i.unit,text:i=>i.unit},{key:"told",label:"told",number:!0,value:i=>i.told,text:i=>n_(i.told)}];return tn({caption:"Parameters",name:"parameters",columns:e,rows:n}).element}function i_({data:n,view:t,version:e}){let i=Number(n.growth.split(":")[1]??0),s=Array.from({length:121},(h,d)=>d*Math.max(i,10)*6/120),r=EE(n.growth),o=[...n.parameters].sort((h,d)=>d.told-h.told).filter(h=>h.told>=.2),a=n.targets,l=K0(n.residuals??[]),c=l.filter(h=>h.looksFalse),u=Gr({row:null}),f=[Zt("overview","Overview","Overview",Gn(se("Growth",n.growth.split(":")[0],"",`the other law has ${(100*n.other_law).toFixed(1)} %`),se("\u03C4",i.toFixed(1),"min",`\xB1 ${ye(n.tau_sigma_min)}`),se("\u03C4 of cooling",n.tau_cool_min===null?Fn:n.tau_cool_min.toFixed(1),"min",n.tau_cool_min===null?"no stop was seen":`\xB1 ${ye(n.tau_cool_sigma_min)}`),se("Touches",ne(n.touches),"",`${we(n.points.length,"point")}${c.length>0?`; ${ne(c.length)} ${c.length===1?"looks":"look"} false`:""}`),se("Noise of one coordinate",At(n.sigma_mm),"mm"),a&&se("Drift at the targets",At(a.drift_rms_mm),"mm","rms, uncorrected","before"),a&&se("The table would leave",At(a.left_rms_mm),"mm",`rms; one shift of the work object ${At(a.shift_left_rms_mm)}`,"after")),Pr(t)),Zt("curves","How it grows, and how far each point goes","Curves",k("div",{class:"plots"},Nn({title:"Share of the settled deformation",x:s,xLabel:"warm-up minute",yLabel:"share",height:240,text:`${n.growth}`,series:[{label:`${n.growth.split(":")[0]}, \u03C4 ${i.toFixed(1)} min`,colour:"after",values:s.map(r)}],marks:()=>n.stops.flatMap(h=>h.map(d=>({at:d,colour:"bucket",dash:[3,3]})))}).element,...j0(l,n,u),k("div",{},k("h3",{text:"Settled shift of each point, by its own touches"}),os({label:"Settled shift",most:Math.max(...n.points.map(h=>Math.hypot(...h.settled_mm)),1e-9),rows:n.points.map(h=>({label:h.point,value:Math.hypot(...h.settled_mm),text:`${At(Math.hypot(...h.settled_mm),3)} mm (${h.settled_mm.map(d=>At(d,3)).join(", ")})`,colour:"after"}))})))),l.length>0&&Zt("touches",`Every touch${c.length>0?`: ${we(c.length,"touch").replace("touchs","touches")} of ${ne(l.length)} ${c.length===1?"looks":"look"} false`:`: none of ${ne(l.length)} looks false`}`,"Touches",k("p",{class:"notice",text:"Looks false: what the fit leaves of it is longer than five standard deviations, these from the middle one of all. It is set aside; where more than 15 % of the touches look false, all count: such an arm drifts in another way, or the tip is elsewhere."}),Q0(l,u)),Zt("parameters",`What the touches tell: ${o.length} of ${n.parameters.length} parameters`,"Parameters",o.length>0&&os({label:"Share that the data tell",most:1,rows:o.slice(0,16).map(h=>({label:`joint ${h.joint} ${h.parameter}: ${cd(h,h.value)} \xB1 ${cd(h,h.sigma)} ${h.unit}`,value:h.told,text:n_(h.told),colour:"after"}))}),AE(n.parameters)),a&&Zt("targets","At the targets","Targets",ni("targets",a.each),a.next&&k("p",{class:"notice",text:`Touch next at joints ${a.next.q_deg.map(h=>h.toFixed(1)).join(", ")} deg (${a.next.at_mm.map(h=>h.toFixed(0)).join(", ")} mm): ${At(a.next.left_rms_mm)} mm would be left.`})),Hn(t.provenance??[],e)].map(h=>()=>h);return{kind:"fit of a warm-up",verdict:`${n.growth.split(":")[0]}, \u03C4 ${i.toFixed(1)} min`,tone:c.length>0?"warn":"good",sections:f}}var CE=["effect","joint","posterior","size","sigma","unit","rms_mm","evidence_nats","source"],s_=n=>n.pose_id??n.id??`line ${n.line}`;function RE({verdict:n,within:t}){return n?{verdict:n,tone:t===!0?"good":"bad"}:n===void 0&&t===!1?{verdict:"NO GO: beyond a limit",tone:"bad"}:{verdict:n===null?"Measured; no limit was given":"No limit was exceeded",tone:""}}function r_({data:n,view:t,version:e}){let{worst:i}=n,s=n.poses.map((a,l)=>({pose:s_(a),line:a.line,"AP mm":a.ap_mm,"RP mm":a.repeatability?.rp_mm??null,n:a.repeatability?.n??1,"drift of AP mm":a.drift_ap_mm,"drift of RP mm":a.drift_rp_mm,joints:a.q_deg.map(c=>c.toFixed(1)).join(", ")})),r=Math.max(...n.poses.map(a=>a.ap_mm),1e-9),o=[Zt("overview","Overview","Overview",Gn(se("Pose accuracy AP",At(i.ap_mm),"mm","the worst pose"),se("Repeatability RP",At(i.rp_mm),"mm","the worst pose"),se("Drift of AP",At(i.drift_ap_mm),"mm","the worst pose"),se("Poses",ne(n.poses.length)),n.multi_directional_mm!==null&&se("Multi-directional",At(n.multi_directional_mm),"mm")),Pr(t)),Zt("poses","Pose by pose","Poses",os({label:"Pose accuracy",most:r,rows:[...n.poses].sort((a,l)=>l.ap_mm-a.ap_mm).slice(0,12).map(a=>({label:s_(a),value:a.ap_mm,text:`AP ${At(a.ap_mm)} mm${a.repeatability?`, RP ${At(a.repeatability.rp_mm)} mm`:""}`,colour:"after"}))}),ni("poses",s)),Hn(t.provenance??[],e)].map(a=>()=>a);return{kind:"ISO 9283",...RE(n),sections:o}}function o_({data:n,view:t,version:e}){let i=n.tools.map((r,o)=>({reflector:o+1,"moved by (mm)":Math.hypot(...r.by_mm),"x (mm)":r.by_mm[0],"y (mm)":r.by_mm[1],"z (mm)":r.by_mm[2],"sigma (mm)":r.sigma_mm})),s=[Zt("overview","Overview","Overview",Gn(se("The points have moved by",At(n.rms_mm),"mm",n.noise_rms_mm===null?"rms, base and tool refitted":`rms; noise alone would be ${At(n.noise_rms_mm)}`,"before"),se("Poses in both",ne(n.pairs),"",`${n.alone[0]} only before, ${n.alone[1]} only after`),se("Base and instrument",At(Math.hypot(...n.base.by_mm),3),"mm",`turned by ${ye(n.base.turned_deg)} deg`)),Pr(t)),i.length>0&&Zt("tools","The tool","Tool",ni("tools",i)),n.causes.length>0&&Zt("causes","What has changed","Causes",os({label:"Probability",most:1,rows:n.causes.slice(0,12).map(r=>({label:ir(r),value:r.posterior,text:`${(100*r.posterior).toFixed(1)} %`,colour:"after"}))}),ni("causes",n.causes.map(r=>Oo(r,CE)))),n.worst.length>0&&Zt("worst","Poses that have moved most","Poses",ni("worst",n.worst.map(r=>Oo(r,["line_before","line_after","mm"])))),Hn(t.provenance??[],e)].map(r=>()=>r);return{kind:"comparison of two measurements",verdict:n.changed?"Changed":"Not changed",tone:n.changed?"warn":"good",sections:s}}function a_({data:n,view:t,version:e}){let{before:i,after:s}=n,r=Math.max(i.true_max_mm,s.true_max_mm),o=(l,c,u)=>({label:l,value:c,text:`${At(c)} mm`,colour:u}),a=[Zt("overview","Overview","Overview",k("p",{class:"reason",text:`Injected: ${n.withheld}. ${t.text?`Found: ${t.text}.`:""}`}),Gn(se("Truly, before",At(i.true_rms_mm),"mm",`rms of ${we(n.targets,"target")}; ${At(i.true_max_mm)} at worst`,"before"),se("Truly, after",At(s.true_rms_mm),"mm",`rms; ${At(s.true_max_mm)} at worst`,"after"),se("Noise floor",At(n.floor_rms_mm),"mm","rms in space"),se("Verdict",n.verdict.replaceAll("_"," "))),os({label:"Errors before and after",most:r,rows:[o("before, at worst",i.true_max_mm,"before"),o("before, rms",i.true_rms_mm,"before"),o("after, at worst",s.true_max_mm,"after"),o("after, rms",s.true_rms_mm,"after"),o("noise of the measurement",n.floor_rms_mm,"plain")]})),n.causes.length>0&&Zt("causes","What was found","Causes",ni("causes",n.causes.map(l=>typeof l=="string"?{cause:l}:l))),Hn(t.provenance??[],e)].map(l=>()=>l);return{kind:"closed loop",verdict:`${At(i.true_rms_mm)} mm before, ${At(s.true_rms_mm)} mm after`,tone:s.true_rms_mm<i.true_rms_mm?"good":"warn",sections:a}}var l_=n=>({...n,file:n.file?hh(n.file):n.file});function PE(n,t){let e=n.map(a=>a.t_min);if(!(t.length>0||e.some((a,l)=>l>0&&a<e[l-1])))return{x:e,label:"warm-up minute",values:a=>n.map(a)};let s=t.filter(a=>a.standing&&a.to_min>a.from_min).map(a=>({at:(a.from_min+a.to_min)/2,pass:null})),o=[...[0,Math.max(...n.map(a=>a.at_min),...t.map(a=>a.to_min))].map(a=>({at:a,pass:null})),...n.map(a=>({at:a.at_min,pass:a})),...s].sort((a,l)=>a.at-l.at);return{x:o.map(a=>a.at),label:"minutes since the beginning",values:a=>o.map(l=>l.pass?a(l.pass):null)}}function IE(n){let t=new Map;for(let e of n)t.set(e.from_min,[...t.get(e.from_min)??[],e]);return[...t].map(([e,i])=>{let s=i.find(r=>r.standing);return{at:e,label:i.map(r=>r.words).join(", "),colour:"bucket",dash:[3,3],to:s?.to_min,shade:s&&"shade"}})}function LE(n,t){let{x:e,label:i,values:s}=PE(n,t),r=n.length===1,o=IE(t),a=Math.max(...n.map(f=>f.after.max_mm??0)),l={x:e,xLabel:i,height:300,marks:()=>o},c=o.map(f=>`${f.label} at minute ${ye(f.at)}`).join(", "),u=(f,h,d)=>({label:f,colour:h,dots:r,gaps:!0,values:s(d)});return[Nn({...l,title:"Worst error of the TCP",yLabel:"mm",text:`Worst error as executed ${At(a)} mm. ${c}`,series:[u("original","before",f=>f.before.max_mm),u("as executed","after",f=>f.after.max_mm),u("path between targets, as executed","claim",f=>f.path_after_mm)]}).element,t.length>0&&Nn({...l,title:"How warm the robot is",yLabel:"warm-up minute",text:`Warm-up minute of the robot and of the program's clock. ${c}`,series:[u("the robot","before",f=>f.t_min),u("by the program's clock","after",f=>f.program_min)]}).element].filter(Boolean)}function c_({data:n,view:t,version:e}){let i=n.minutes,s=n.worst,r=i.map(h=>h.t_min),o=h=>i.reduce((d,g)=>Math.max(d,h(g)??0),0),a=i.length===1,l=n.marks??[],c=i.map(h=>({t_min:h.t_min,motions:h.n,"before max (mm)":h.before.max_mm,"before rms (mm)":h.before.rms_mm,"after max (mm)":h.after.max_mm,"after rms (mm)":h.after.rms_mm,"path (mm)":h.path_after_mm,unreached:h.unreached,failure:h.failure,mismatch:h.mismatch})),u=i.some(h=>h.failure||h.mismatch),f=[Zt("overview","Overview","Overview",Gn(se("Worst error of the original",At(o(h=>h.before.max_mm)),"mm","on the deformed robot","before"),se("Worst error as executed",At(o(h=>h.after.max_mm)),"mm",s&&`minute ${ye(s.t_min)}, ${hh(s.file)}:${s.line}`,"after"),se("Motions executed",ne(n.executed.motions),"",`of ${ne(n.executed.of)} in the program`),se(a?"Minute":"Passes",a?ye(r[0]):ne(i.length)),n.switches.length>0&&se("Largest step at a switch",At(Math.max(...n.switches.map(h=>h.jump_mm))),"mm",we(n.switches.length,"switch").replace("switchs","switches"))),Pr(t)),i.length>0&&Zt("curves","Errors at each minute","Curves",k("div",{class:"plots"},LE(i,l)),l.length>0&&ni("steps",l.map(h=>({step:h.words,"from (min)":h.from_min,"to (min)":h.to_min,"the robot stands":h.standing}))),ni("passes",c)),...e_({...n,switches:n.switches.map(h=>Oo(h,["t_min","jump_mm"])),functions:n.functions.map(h=>Oo(h,["name","calls","statements","arithmetic","trigonometric"])),messages:n.messages.map(l_),unchanged:n.unchanged.map(l_)},{switches:"Switches",unchanged:"Motions not corrected",messages:"Messages",unknown_instructions:"Unknown instructions",functions:"Functions"}),Hn(t.provenance??[],e)].map(h=>()=>h);return{kind:"simulation",verdict:`${we(n.executed.motions,"motion")} executed: ${At(o(h=>h.after.max_mm))} mm at worst`,tone:u||n.executed.motions===0?"bad":"good",sections:f}}var DE=4,Ph={tcMinute:["Warm-up minute","min"],tcDegrees:["Temperature","\xB0C"],tcBucket:["Bucket",""],tcShare:["Share of the drift",""],tcTouchSigma:["Known by touch to",""],tcTouchAge:["Touched","min ago"]};function NE(n,t){return n===-1?"follows the clock":n===-2?"originals":n>=0?t?`held at ${ye(n)} %`:`held at bucket ${ye(n)}`:String(n)}var Xa=n=>typeof n=="number"?ye(n):String(n),h_=({values:n})=>n.tcBucket===-1||n.tcMode===-2;function u_({data:n,title:t,version:e}){let i=[...new Set(n.records.map(c=>`${c.task}/${c.module}`))],s=new Map(i.map(c=>[c,n.records.filter(u=>`${u.task}/${u.module}`===c)])),r=i.map(c=>s.get(c).at(-1)),o=[()=>Zt("now","Now","Now",UE(n),i.map(c=>FE(c,s.get(c).at(-1))),n.warnings.length>0&&[k("h3",{class:"apart",text:we(n.warnings.length,"warning")}),Oi([...n.warnings].reverse().map(c=>({code:`second ${ye(c.t_s)}`,message:c.text})),"warn")]),...i.map(c=>()=>OE(c,s.get(c))),()=>Hn([["controller",t],["looks",n.shown<n.seen?`${ne(n.seen)}, of which ${ne(n.shown)} are on this page: older ones are thinned out`:ne(n.seen)]],e)],a=r.map(c=>h_(c)?"original targets":"corrected").join(", "),l=r.some(c=>c.said||h_(c))||n.warnings.length>0||n.ended;return{kind:"link watch",verdict:a||"nothing seen yet",tone:l?"warn":"good",sections:o}}function UE(n){let t=new Date(n.written_s*1e3),e=k("p",{class:"calm","data-name":"fresh",role:"status"}),i=new URLSearchParams(location.hash.slice(1));i.has("theme")&&_f(i.get("theme"));let s=!n.ended&&!i.has("hold"),r=()=>{let l=new URLSearchParams;document.documentElement.dataset.theme&&l.set("theme",document.documentElement.dataset.theme),!s&&!n.ended&&l.set("hold","1"),scrollY>0&&l.set("y",String(Math.round(scrollY))),history.replaceState(null,"",`#${l}`)};ss(r);let o=()=>(Date.now()-t)/1e3,a=()=>{let l=`As of ${t.toLocaleString()}`;n.ended?e.textContent=`${l}. ${n.ended}`:o()>DE*n.every_s?e.textContent=`${l}: ${Math.round(o())} seconds old. Nothing new has been written since: the watch may have ended.`:e.textContent=`${l}; written anew every ${ye(n.every_s)} seconds.`};return a(),setInterval(a,1e3),setInterval(()=>{!s||document.hidden||(r(),location.reload())},n.every_s*1e3),i.has("y")&&addEventListener("page-whole",()=>scrollTo(0,Number(i.get("y"))),{once:!0}),[e,!n.ended&&Fa({label:`load the page anew every ${ye(n.every_s)} seconds`,name:"reload",value:s,on:l=>{s=l,r()}})]}function FE(n,{values:t,said:e}){let{tcMode:i,...s}=t;return[k("h3",{class:"apart",text:n}),e&&Oi([{code:"it said",message:e}],"warn"),Gn(i!==void 0&&se("tcMode",Xa(i),"",NE(i,"tcShare"in t)),Object.entries(s).map(([r,o])=>se(Ph[r]?.[0]??r,r==="tcBucket"&&o===-1?"originals":Xa(o),r==="tcBucket"?"":Ph[r]?.[1],r)))]}function OE(n,t){let e=t.map(a=>a.t_s/60),i=Object.keys(t.at(-1).values).filter(a=>a!=="tcMode"&&t.some(l=>typeof l.values[a]=="number")),s=t.filter((a,l)=>l===0||["tcMode","tcBucket"].some(c=>a.values[c]!==t[l-1].values[c])||a.said!==t[l-1].said),r=[{key:"t",label:"minute of the watch",number:!0,value:a=>a.t_s,text:a=>(a.t_s/60).toFixed(2)},...Object.keys(t.at(-1).values).map(a=>({key:a,label:a,number:!0,value:l=>l.values[a],text:l=>Xa(l.values[a])})),{key:"said",label:"it said",value:a=>a.said??"",text:a=>a.said??"",class:"reason"}],o=t.length===1;return Zt(`course-${n.replace(/\W/g,"-")}`,`${n}: how it went`,n.split("/")[1],k("div",{class:"plots"},i.map(a=>Nn({title:Ph[a]?.[0]??a,x:e,xLabel:"minutes of the watch",yLabel:Ph[a]?.[1]||a,height:210,zero:a!=="tcDegrees",text:`${a} from ${Xa(t[0].values[a])} to ${Xa(t.at(-1).values[a])}`,series:[{label:a,colour:"after",dots:o,values:t.map(l=>typeof l.values[a]=="number"?l.values[a]:null)}]}).element)),k("h3",{class:"apart",text:"Changes of mode, bucket and message"}),tn({caption:"Changes",name:"changes",columns:r,rows:[...s].reverse(),searchable:!1}).element,Es("All looks",()=>tn({caption:"Looks",name:"looks",columns:r,rows:[...t].reverse(),searchable:!1}).element))}var BE={compensate:V0,diagnose:Z0,simulate:c_,fit:i_,accuracy:r_,"compare-measurements":o_,"closed-loop":a_,"link watch":u_},$a=JSON.parse(document.getElementById("data").textContent),qa=$a.view.tasks?$a.data.tasks:null,hd=qa&&Math.min(Math.max(Number(new URLSearchParams(location.search).get("task")??1)-1,0),qa.length-1)||0,Ih=qa?{...$a,data:qa[hd],view:$a.view.tasks[hd]}:$a,kE=BE[Ih.command]??t_,{kind:zE,verdict:VE,tone:GE,sections:HE}=kE(Ih),f_=k("main",{id:"main",tabIndex:-1}),d_=Zm({title:Ih.title,kind:zE,verdict:VE,tone:GE,version:Ih.version,tasks:qa?.map(n=>n.task),which:hd});document.getElementById("page").replaceChildren(k("a",{class:"skip",href:"#main",text:"Skip to the contents"}),d_.element,f_);function p_(n){let[t,...e]=n;if(!t){document.documentElement.dataset.whole="yes",dispatchEvent(new Event("page-whole"));return}let i=t();i&&(f_.append(i),d_.link(i));let s=()=>p_(e);document.hidden?setTimeout(s):requestAnimationFrame(()=>setTimeout(s))}p_(HE);
